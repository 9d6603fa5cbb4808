// stb's TrueType reader, compiled once and apart, so that its warnings stay out of our code.
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb_truetype.h>
