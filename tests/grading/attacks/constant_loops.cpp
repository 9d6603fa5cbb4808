template <int n>
constexpr long turns() {
  long sum = n;
  for (long i = 0; i < 200000; ++i) sum = (sum * 31 + i) % 1000003;
  return sum;
}
template <int... n>
constexpr long all() {
  return (turns<n>() + ...);
}
#define TEN(x) x##0, x##1, x##2, x##3, x##4, x##5, x##6, x##7, x##8, x##9
#define HUNDRED(x) \
  TEN(x##0), TEN(x##1), TEN(x##2), TEN(x##3), TEN(x##4), TEN(x##5), TEN(x##6), TEN(x##7)
static_assert(all<HUNDRED(1), HUNDRED(2), HUNDRED(3), HUNDRED(4)>() != 0);
static_assert(all<HUNDRED(5), HUNDRED(6), HUNDRED(7), HUNDRED(8)>() != 0);
