# SPDX-License-Identifier: LGPL-2.1-or-later
#
# thicken_warnings: linked privately by every target of this project, never exported.
add_library(thicken_warnings INTERFACE)
if(MSVC)
  target_compile_options(thicken_warnings INTERFACE /W4 $<$<BOOL:${THICKEN_WERROR}>:/WX>)
else()
  target_compile_options(thicken_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow
                         $<$<BOOL:${THICKEN_WERROR}>:-Werror>)
endif()
