#pragma once

#include <algorithm>
#include <vector>

namespace tests {

/// What a test is about while it asks the answer: a crash or a loop in there tells no more.
class UnderWay {
 public:
  UnderWay() { under_way.push_back(this); }
  UnderWay(const UnderWay& /*other*/) { under_way.push_back(this); }
  UnderWay& operator=(const UnderWay&) = default;
  virtual ~UnderWay() {
    under_way.erase(std::find(under_way.rbegin(), under_way.rend(), this).base() - 1);
  }

  /// The newest one tells of itself on stderr; false where none is under way.
  static bool tell_of_newest() {
    if (under_way.empty()) return false;
    under_way.back()->tell();
    return true;
  }

 private:
  virtual void tell() const = 0;

  inline static std::vector<const UnderWay*> under_way;
};

}  // namespace tests
