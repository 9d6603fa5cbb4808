static int deeper(volatile int* above) {
  volatile int here[1024];
  here[0] = *above + 1;
  return deeper(here) + here[0];
}

static void attack() {
  volatile int start = 0;
  static_cast<void>(deeper(&start));
}
