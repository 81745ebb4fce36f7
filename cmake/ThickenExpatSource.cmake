# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Target EXPAT::EXPAT made of Expat's source as a static library, for files that are to run elsewhere.
# -DFETCHCONTENT_SOURCE_DIR_EXPAT=… names a folder that has the source.
include(ThickenStaticSource)

FetchContent_Declare(expat
  URL https://deb.debian.org/debian/pool/main/e/expat/expat_2.5.0.orig.tar.gz
      http://deb.debian.org/debian/pool/main/e/expat/expat_2.5.0.orig.tar.gz
  URL_HASH SHA256=ab00ee05c7067fd10a35c5d2a4922ebba746ddd50ff83b79c828da17bbdf1757
  DOWNLOAD_EXTRACT_TIMESTAMP OFF)

function(thicken_add_expat)
  foreach(part IN ITEMS DOCS EXAMPLES FUZZERS PKGCONFIG TESTS TOOLS)
    set(EXPAT_BUILD_${part} OFF)
  endforeach()
  set(EXPAT_SHARED_LIBS OFF)
  set(EXPAT_ENABLE_INSTALL OFF)
  thicken_add_static(expat expat)
  # It sets no folder of headers for those who build it along with them.
  target_include_directories(expat PUBLIC "$<BUILD_INTERFACE:${expat_SOURCE_DIR}/expat/lib>")
  target_compile_definitions(expat PUBLIC XML_STATIC)
endfunction()
thicken_add_expat()

add_library(EXPAT::EXPAT ALIAS expat)
