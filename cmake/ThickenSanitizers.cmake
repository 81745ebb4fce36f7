# SPDX-License-Identifier: LGPL-2.1-or-later
#
# THICKEN_SANITIZE applies to all targets: sanitized and plain objects must not be mixed.
if(THICKEN_SANITIZE)
  add_compile_options(-fsanitize=${THICKEN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${THICKEN_SANITIZE})
endif()
