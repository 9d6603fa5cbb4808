#pragma once

#include <concepts>
#include <exception>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "catch.hpp"
#include "common/course/not_implemented.hpp"
#include "under_way.hpp"
#include "values.hpp"

namespace tests {

/// The largest error of a right answer, and the reason for it.
struct Bound {
  double value;
  std::string reason;
};

/// The value that a known mistake would have returned for the same input.
template <typename Value>
struct Suspect {
  Value value;
  std::string story;
};

/// One input on which a contract function is judged. A judgement that fails explains itself on
/// stderr, one fact a line, each after "| ": step, case, input, got, wanted, error, bound, likely.
/// If the answer crashes or never returns, run_each makes it tell step, case and input.
class Trial : private UnderWay {
 public:
  /// step_and_function  as the stub throws it: "1.2 point_velocity"
  /// index, count       the number of this input, from 1, and the number of inputs of the test case
  explicit Trial(std::string step_and_function, int index = 1, int count = 1)
      : step_(std::move(step_and_function)), index_(index), count_(count) {}

  /// Adds an argument, which is printed as C++ that can be pasted. It is kept as it is now, and
  /// becomes a text only if a judgement fails, because printing takes longer than judging.
  template <typename Value>
  Trial& given(const std::string& name, const Value& value) {
    if constexpr (requires { typename Value::PlainObject; }) {
      keep(name, typename Value::PlainObject(value));  // an expression of Eigen refers to others
    } else {
      keep(name, value);
    }
    return *this;
  }

  /// Sets what names a likely mistake if a judgement fails and not exactly one suspect fits.
  /// likely  is called only then; it returns an empty text if it cannot tell, see fingerprint.hpp
  Trial& suspecting(std::function<std::string()> likely) {
    likely_ = std::move(likely);
    return *this;
  }

  /// Returns the same trial for one part of the result, as in "the torque".
  [[nodiscard]] Trial of(const std::string& part) const {
    Trial trial = *this;
    trial.part_ = part;
    return trial;
  }

  /// Requires |got − wanted| ≤ bound, in the norm of values.hpp. If exactly one suspect gives the
  /// value of the answer (twice the bound is allowed), it is named as the likely mistake.
  template <typename Value>
  void expect(const Value& got, const Value& wanted, const Bound& bound,
              const std::vector<Suspect<Value>>& suspects = {}) const {
    expect(got, wanted, bound, [&]() -> const std::vector<Suspect<Value>>& { return suspects; });
  }

  /// Does the same with suspects that are computed only if the judgement fails.
  /// suspects  a function without arguments that returns a vector of them
  template <typename Value, std::invocable Suspects>
  void expect(const Value& got, const Value& wanted, const Bound& bound,
              const Suspects& suspects) const {
    if (!is_finite(got)) fail_not_finite(text(got), text(wanted));
    const double error = difference(got, wanted);
    if (!(error <= bound.value)) {
      std::vector<std::string> stories;
      const std::vector<Suspect<Value>>& all = suspects();
      for (const Suspect<Value>& suspect : all) {
        const bool looks_right = difference(suspect.value, wanted) <= 4.0 * bound.value;
        const double tolerance = 2.0 * bound.value + 8.0 * eps * length(suspect.value);
        if (!looks_right && difference(got, suspect.value) <= tolerance) {
          stories.push_back(suspect.story);
        }
      }
      explain(text(got), text(wanted), text(error), text(bound.value) + ": " + bound.reason,
              stories);
    }
    REQUIRE(error <= bound.value);
  }

  /// Requires a property of the result: `error` ≤ bound. `what` says what the error measures.
  /// likely  a mistake whose sign the caller has seen, or empty
  void expect_small(const std::string& what, double error, const Bound& bound,
                    const std::string& likely = "") const {
    if (!is_finite(error)) fail_not_finite(what + " = " + text(error), "0");
    if (!(error <= bound.value)) {
      explain(what + " = " + text(error), "0", text(error), text(bound.value) + ": " + bound.reason,
              named(likely));
    }
    REQUIRE(error <= bound.value);
  }

  /// Returns the result of the call. It explains an exception with the input, but lets
  /// NotImplemented pass.
  template <typename Call>
  auto returned(const Call& call) const {
    try {
      return call();
    } catch (const common::NotImplemented&) {
      throw;
    } catch (const std::exception& error) {
      explain(std::string("an exception: ") + error.what(), "a value", "this input has an answer",
              "", {});
      throw;
    }
  }

  /// Requires that the call throws an Expected; lets NotImplemented pass.
  /// likely  the mistake if it returns a value, or empty
  template <typename Expected = std::invalid_argument, typename Call>
  void expect_throw(const Call& call, const std::string& why,
                    const std::string& likely = "") const {
    try {
      const auto got = call();
      const std::string wanted = "an exception, because " + why;
      const std::string error =
          is_finite(got) ? "nothing is thrown" : "not finite, and nothing is thrown";
      explain(text(got), wanted, error, "", named(likely));
    } catch (const common::NotImplemented&) {
      throw;
    } catch (const Expected&) {
      SUCCEED("it throws");
      return;
    } catch (const std::exception& error) {
      explain(std::string("an exception of another type: ") + error.what(),
              "the type that the header names", "why: " + why, "", {});
    }
    FAIL(step_ << " must throw what the header says: " << why);
  }

 private:
  static constexpr const char* not_finite =
      "not finite: NaN and infinity are never right here; vectors and matrices stay NaN until "
      "you set them";

  template <typename Value>
  void keep(const std::string& name, const Value& value) {
    inputs_.push_back([name, value] { return name + " = " + text(value) + ";"; });
  }

  static std::vector<std::string> named(const std::string& likely) {
    return likely.empty() ? std::vector<std::string>{} : std::vector<std::string>{likely};
  }

  [[noreturn]] void fail_not_finite(const std::string& got, const std::string& wanted) const {
    explain(got, wanted, not_finite, "", {});
    FAIL(step_ << " returned a value that is not finite");
    std::terminate();  // FAIL throws
  }

  [[nodiscard]] std::string asked() const {
    std::string lines = "| step    " + step_ + "\n";
    if (count_ > 1) {
      lines += "| case    " + std::to_string(index_) + " of " + std::to_string(count_) + "\n";
    }
    for (const auto& input : inputs_) lines += "| input   " + input() + "\n";
    return lines;
  }

  void tell() const override { std::cerr << asked() << std::flush; }

  /// If two stories fit, none is named, because only a sure sign counts.
  void explain(const std::string& got, const std::string& wanted, const std::string& error,
               const std::string& bound, const std::vector<std::string>& stories) const {
    std::string lines = asked();
    if (!part_.empty()) lines += "| note    this is about " + part_ + "\n";
    lines += "| got     " + got + "\n| wanted  " + wanted + "\n| error   " + error + "\n";
    if (!bound.empty()) lines += "| bound   " + bound + "\n";
    std::cerr << lines << std::flush;  // flushed, because the answer may crash on other inputs
    std::string likely = stories.size() == 1 ? stories.front() : "";
    if (likely.empty() && likely_) likely = likely_();
    if (!likely.empty()) std::cerr << "| likely  " << likely << "\n" << std::flush;
  }

  std::string step_;
  std::string part_;
  int index_;
  int count_;
  std::vector<std::function<std::string()>> inputs_;
  std::function<std::string()> likely_;
};

}  // namespace tests
