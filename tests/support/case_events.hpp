#pragma once

#include <cstddef>
#include <string>

namespace tests {

/// A listener that Catch2 calls when a case begins and ends.
class CaseEvents {
 public:
  CaseEvents() = default;
  CaseEvents(const CaseEvents&) = delete;
  CaseEvents& operator=(const CaseEvents&) = delete;
  virtual ~CaseEvents() = default;

  virtual void starts(const std::string& name) = 0;
  /// assertions  their number; 0 if one failed, because then the number does not matter
  virtual void ends(std::size_t assertions) = 0;

  /// Sends the events to this listener from now on; nullptr, as at first, sends them nowhere.
  static void tell(CaseEvents* listener);
};

}  // namespace tests
