# SPDX-License-Identifier: LGPL-2.1-or-later
#
# thicken_strict_arithmetic: options for each compiler under which every operation is rounded by itself. No contraction to
# fused multiply-add: results must not depend on the compiler's choice, and the error bounds of the exact
# predicates' filters assume separate roundings.
if(MSVC)
  set(thicken_strict_arithmetic /fp:precise)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    list(APPEND thicken_strict_arithmetic /clang:-ffp-contract=off)
  endif()
else()
  set(thicken_strict_arithmetic -ffp-contract=off)
endif()
