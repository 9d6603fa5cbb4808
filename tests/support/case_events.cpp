#include "case_events.hpp"

// Catch2 2 and 3 name what listens to them in different ways.
#if CATCH2_MAJOR >= 3
#include <catch2/catch_test_case_info.hpp>
#include <catch2/reporters/catch_reporter_event_listener.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
using Listener = Catch::EventListenerBase;
#else
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>
using Listener = Catch::TestEventListenerBase;
#endif

namespace {

tests::CaseEvents* listening = nullptr;

class Teller : public Listener {
 public:
  using Listener::Listener;

  void testCaseStarting(const Catch::TestCaseInfo& one) override {
    Listener::testCaseStarting(one);
    if (listening != nullptr) listening->starts(one.name);
  }

  void testCaseEnded(const Catch::TestCaseStats& one) override {
    const Catch::Counts& counts = one.totals.assertions;
    if (listening != nullptr) listening->ends(counts.allPassed() ? counts.passed : 0);
    Listener::testCaseEnded(one);
  }
};

}  // namespace

CATCH_REGISTER_LISTENER(Teller)

void tests::CaseEvents::tell(CaseEvents* listener) { listening = listener; }
