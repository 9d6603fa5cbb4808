#pragma once

#include <cstdint>
#include <tuple>
#include <type_traits>

/// What the two sides of a grader agree on. To add a lab: a folder of its name with remote.hpp,
/// which has fields_of each struct that crosses, and how long an answer may be. The functions are
/// read off the contract, see crossings.py.
namespace grading {

/// The descriptors of a worker on which it is asked and answers; what it prints goes elsewhere.
inline constexpr int request_descriptor = 3;
inline constexpr int answer_descriptor = 4;

struct RequestHead {
  std::uint64_t nonce = 0;  ///< drawn afresh; its answer repeats it, so none can come first
  std::uint32_t size = 0;   ///< of what follows [bytes]
  std::uint32_t function = 0;
};

/// How a call ended.
enum class Ending : std::uint32_t {
  value,
  not_implemented,
  invalid_argument,
  domain_error,
  out_of_memory,
  exception,  ///< of another type
};

struct AnswerHead {
  std::uint64_t nonce = 0;
  std::uint64_t allocations = 0;  ///< that the call made
  std::uint32_t size = 0;
  Ending ending = Ending::value;
};

template <auto function>
struct Function {};

template <typename Call>
struct Signature;
template <typename R, typename... Parameters>
struct Signature<R (*)(Parameters...)> {
  using Result = R;
  using Values = std::tuple<std::remove_cvref_t<Parameters>...>;
};

/// A lab's functions in an order that both sides share.
///
/// largest_answer  what the longest right answer of the lab's tests takes, with room to spare
/// [bytes]
template <std::uint32_t largest_answer, auto... functions>
struct Contract {
  static constexpr std::uint32_t answer_limit = largest_answer;

  template <auto function>
  static constexpr std::uint32_t index_of() {
    static_assert((std::is_same_v<Function<function>, Function<functions>> || ...));
    std::uint32_t index = 0;
    // Counts up to the first that is it.
    static_cast<void>(
        ((std::is_same_v<Function<function>, Function<functions>> || (++index, false)) || ...));
    return index;
  }
};

}  // namespace grading
