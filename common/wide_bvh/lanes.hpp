#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

/// Numbers side by side, as many as fit into a register of the processor that this is compiled for.
/// The operators are the compiler's. A comparison gives all ones or all zeros for each lane, and
/// `mask ? x : y` picks.
namespace common {

#if defined(__AVX__)
inline constexpr std::size_t register_bytes = 32;
#else
inline constexpr std::size_t register_bytes = 16;
#endif

using Doubles [[gnu::vector_size(register_bytes)]] = double;
using DoubleMask [[gnu::vector_size(register_bytes)]] = std::int64_t;
using Floats [[gnu::vector_size(register_bytes)]] = float;
using FloatMask [[gnu::vector_size(register_bytes)]] = std::int32_t;
inline constexpr std::size_t double_lanes = register_bytes / sizeof(double);
inline constexpr std::size_t float_lanes = register_bytes / sizeof(float);

/// Loads from memory of any alignment.
template <typename Lanes, typename Number>
Lanes loaded(const Number* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

template <typename Lanes, typename Number>
void store(const Lanes& lanes, Number* to) {
  std::memcpy(to, &lanes, sizeof lanes);
}

template <typename Lanes>
Lanes least(const Lanes& a, const Lanes& b) {
  return a < b ? a : b;
}
template <typename Lanes>
Lanes greatest(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}
template <typename Lanes>
Lanes size_of(const Lanes& a) {
  return greatest(a, -a);
}

/// Returns one bit for each lane, the first lane's bit lowest.
inline std::uint32_t bits(const DoubleMask& mask) {
#if defined(__AVX__)
  return static_cast<std::uint32_t>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
#elif defined(__SSE2__)
  return static_cast<std::uint32_t>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask)));
#else
  std::uint32_t result = 0;
  for (std::size_t i = 0; i < double_lanes; ++i) result |= (mask[i] != 0 ? 1U : 0U) << i;
  return result;
#endif
}
inline std::uint32_t bits(const FloatMask& mask) {
#if defined(__AVX__)
  return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#elif defined(__SSE2__)
  return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
  std::uint32_t result = 0;
  for (std::size_t i = 0; i < float_lanes; ++i) result |= (mask[i] != 0 ? 1U : 0U) << i;
  return result;
#endif
}

}  // namespace common
