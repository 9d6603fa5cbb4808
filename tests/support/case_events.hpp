#pragma once

#include <cstddef>
#include <string>

namespace tests {

/// Who is told by Catch2 that a case begins and ends.
class CaseEvents {
 public:
  CaseEvents() = default;
  CaseEvents(const CaseEvents&) = delete;
  CaseEvents& operator=(const CaseEvents&) = delete;
  virtual ~CaseEvents() = default;

  virtual void starts(const std::string& name) = 0;
  /// assertions  how many there were; 0 where one failed, since then the number is of no interest
  virtual void ends(std::size_t assertions) = 0;

  /// From now on these events go there; nullptr: nowhere, as at first.
  static void tell(CaseEvents* listener);
};

}  // namespace tests
