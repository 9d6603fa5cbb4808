#pragma once

#include <concepts>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

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
  explicit Trial(std::string step_and_function, int index = 1, int count = 1);

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
  Trial& suspecting(std::function<std::string()> likely);

  /// Returns the same trial for one part of the result, as in "the torque".
  [[nodiscard]] Trial of(const std::string& part) const;

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
    require_within(error, bound);
  }

  /// Requires a property of the result: `error` ≤ bound. `what` says what the error measures.
  /// likely  a mistake whose sign the caller has seen, or empty
  void expect_small(const std::string& what, double error, const Bound& bound,
                    const std::string& likely = "") const;

  /// Returns the result of the call. It explains an exception with the input, but lets
  /// NotImplemented pass.
  template <typename Call>
  auto returned(const Call& call) const {
    try {
      return call();
    } catch (const common::NotImplemented&) {
      throw;
    } catch (const std::exception& error) {
      explain_exception(error);
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
      explain_no_exception(text(got), is_finite(got), why, likely);
    } catch (const common::NotImplemented&) {
      throw;
    } catch (const Expected&) {
      succeed();
      return;
    } catch (const std::exception& error) {
      explain_other_exception(error, why);
    }
    fail_to_throw(why);
  }

 private:
  template <typename Value>
  void keep(const std::string& name, const Value& value) {
    inputs_.push_back([name, value] { return name + " = " + text(value) + ";"; });
  }

  static void require_within(double error, const Bound& bound);
  static void succeed();
  [[noreturn]] void fail_not_finite(const std::string& got, const std::string& wanted) const;
  [[noreturn]] void fail_to_throw(const std::string& why) const;
  void explain_exception(const std::exception& error) const;
  void explain_other_exception(const std::exception& error, const std::string& why) const;
  void explain_no_exception(const std::string& got, bool finite, const std::string& why,
                            const std::string& likely) const;
  [[nodiscard]] std::string asked() const;
  void tell() const override;

  /// If two stories fit, none is named, because only a sure sign counts.
  void explain(const std::string& got, const std::string& wanted, const std::string& error,
               const std::string& bound, const std::vector<std::string>& stories) const;

  std::string step_;
  std::string part_;
  int index_;
  int count_;
  std::vector<std::function<std::string()>> inputs_;
  std::function<std::string()> likely_;
};

}  // namespace tests
