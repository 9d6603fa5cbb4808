#include "trial.hpp"

#include <iostream>

#include "catch.hpp"

namespace tests {
namespace {

std::vector<std::string> named(const std::string& likely) {
  return likely.empty() ? std::vector<std::string>{} : std::vector<std::string>{likely};
}

}  // namespace

Trial::Trial(std::string step_and_function, int index, int count)
    : step_(std::move(step_and_function)), index_(index), count_(count) {}

Trial& Trial::suspecting(std::function<std::string()> likely) {
  likely_ = std::move(likely);
  return *this;
}

Trial Trial::of(const std::string& part) const {
  Trial trial = *this;
  trial.part_ = part;
  return trial;
}

void Trial::expect_small(const std::string& what, double error, const Bound& bound,
                         const std::string& likely) const {
  if (!is_finite(error)) fail_not_finite(what + " = " + text(error), "0");
  if (!(error <= bound.value)) {
    explain(what + " = " + text(error), "0", text(error), text(bound.value) + ": " + bound.reason,
            named(likely));
  }
  require_within(error, bound);
}

void Trial::require_within(double error, const Bound& bound) { REQUIRE(error <= bound.value); }

void Trial::succeed() { SUCCEED("it throws"); }

void Trial::fail_not_finite(const std::string& got, const std::string& wanted) const {
  explain(got, wanted,
          "not finite: NaN and infinity are never right here; vectors and matrices stay NaN until "
          "you set them",
          "", {});
  FAIL(step_ << " returned a value that is not finite");
  std::terminate();  // FAIL throws
}

void Trial::fail_to_throw(const std::string& why) const {
  FAIL(step_ << " must throw what the header says: " << why);
  std::terminate();  // FAIL throws
}

void Trial::explain_exception(const std::exception& error) const {
  explain(std::string("an exception: ") + error.what(), "a value", "this input has an answer", "",
          {});
}

void Trial::explain_other_exception(const std::exception& error, const std::string& why) const {
  explain(std::string("an exception of another type: ") + error.what(),
          "the type that the header names", "why: " + why, "", {});
}

void Trial::explain_no_exception(const std::string& got, bool finite, const std::string& why,
                                 const std::string& likely) const {
  explain(got, "an exception, because " + why,
          finite ? "nothing is thrown" : "not finite, and nothing is thrown", "", named(likely));
}

std::string Trial::asked() const {
  std::string lines = "| step    " + step_ + "\n";
  if (count_ > 1) {
    lines += "| case    " + std::to_string(index_) + " of " + std::to_string(count_) + "\n";
  }
  for (const auto& input : inputs_) lines += "| input   " + input() + "\n";
  return lines;
}

void Trial::tell() const { std::cerr << asked() << std::flush; }

void Trial::explain(const std::string& got, const std::string& wanted, const std::string& error,
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

}  // namespace tests
