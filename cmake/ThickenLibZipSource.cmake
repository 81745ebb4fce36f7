# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Target LibZip::LibZip made of libzip's source as a static library that packs and nothing else: Debian has no
# static libzip, and other systems none at all. -DFETCHCONTENT_SOURCE_DIR_LIBZIP=… names a folder that has the source.
include(ThickenStaticSource)

FetchContent_Declare(libzip
  URL https://deb.debian.org/debian/pool/main/libz/libzip/libzip_1.7.3.orig.tar.xz
      http://deb.debian.org/debian/pool/main/libz/libzip/libzip_1.7.3.orig.tar.xz
      https://libzip.org/download/libzip-1.7.3.tar.xz
  URL_HASH SHA256=a60473ffdb7b4260c08bfa19c2ccea0438edac11193c3afbbb1f17fbcf6c6132
  DOWNLOAD_EXTRACT_TIMESTAMP OFF)

function(thicken_add_libzip)
  foreach(feature IN ITEMS COMMONCRYPTO GNUTLS MBEDTLS OPENSSL WINDOWS_CRYPTO BZIP2 LZMA)
    set(ENABLE_${feature} OFF)
  endforeach()
  foreach(part IN ITEMS TOOLS REGRESS EXAMPLES DOC)
    set(BUILD_${part} OFF)
  endforeach()
  set(BUILD_SHARED_LIBS OFF)
  thicken_add_static(libzip .)
endfunction()
thicken_add_libzip()

add_library(LibZip::LibZip ALIAS zip)
