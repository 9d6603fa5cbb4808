// stb's PNG writer, compiled once. It packs its rows by our hook instead of its own deflate.
#define STBIW_ZLIB_COMPRESS render_packed_rows
unsigned char* render_packed_rows(unsigned char* rows, int size, int* packed_size, int quality);

#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
