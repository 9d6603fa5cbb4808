// stb's picture reader, compiled once and apart, so that its warnings stay out of our code.
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
