#pragma once

#include <algorithm>
#include <vector>

namespace tests {

/// Tells what a test asks the answer. In a crash or a loop the test itself can no longer tell.
class UnderWay {
 public:
  UnderWay() { under_way.push_back(this); }
  UnderWay(const UnderWay& /*other*/) { under_way.push_back(this); }
  UnderWay& operator=(const UnderWay&) = default;
  virtual ~UnderWay() {
    under_way.erase(std::find(under_way.rbegin(), under_way.rend(), this).base() - 1);
  }

  /// Lets the newest one describe itself on stderr. Returns false if none is under way.
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
