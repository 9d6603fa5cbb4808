#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <tuple>

#include "allocation_count.hpp"
#include "codec.hpp"
#include "contract.hpp"

namespace grading {

/// What a worker sent back.
struct Answer {
  AnswerHead head;
  std::string bytes;
};

/// Asks the worker, which the first question of this process starts as the file says that is named
/// in TUMBLE_WORKER: its command line, an argument a line. A worker that dies, is late, sends too
/// much or anything but an answer to this very question ends this process: the case is over. Its
/// last line is then "tumble-judge: " and the word for it.
Answer ask(std::uint32_t function, const std::string& arguments, std::uint32_t answer_limit);

/// Throws what the worker says its function threw; the text cut, and without what could pass for a
/// line of the tests.
[[noreturn]] void rethrow(const Answer& answer);

/// Ends this process: the case fails for the reason `fate`.
[[noreturn]] void end_case(const std::string& fate);

/// A function of a contract, called in the worker.
template <typename Contract, auto function>
struct Remote {
  template <typename... Arguments>
  auto operator()(const Arguments&... arguments) const {
    using Call = Signature<decltype(function)>;
    const std::size_t before = tests::allocations;
    Writer request;
    Codec<typename Call::Values>::write(request, typename Call::Values(arguments...));
    const Answer answer =
        ask(Contract::template index_of<function>(), request.bytes(), Contract::answer_limit);
    if (answer.head.ending != Ending::value) {
      tests::allocations = before + answer.head.allocations;
      rethrow(answer);
    }
    auto result = result_of<typename Call::Result>(answer);
    // Of the two sides of the pipe only the worker's own counts.
    tests::allocations = before + answer.head.allocations;
    return result;
  }

 private:
  template <typename Result>
  static Result result_of(const Answer& answer) {
    try {
      Reader reader(answer.bytes);
      return decoded<Result>(reader);
    } catch (const Malformed&) {
      end_case("malformed");
    }
  }
};

}  // namespace grading
