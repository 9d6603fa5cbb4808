// exit_group(0) without the name of a function.
static void attack() {
#if defined(__x86_64__)
  asm volatile("syscall" : : "a"(231), "D"(0) : "rcx", "r11", "memory");
#else
#error only for x86-64
#endif
}
