// One fault at a time in the mirrors of an axle.
#include <string>

#include <gtest/gtest.h>

#include "tests/vehicles/mirrored_axle.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/reader/findings.h"
#include "vehicles/tags/findings.h"

namespace fourpost::mirror_faults_test {
namespace {

class MirrorFaults : public VehicleFileTest {
 protected:
  void ExpectOnly(const std::string& more, const Finding& kind, const std::vector<std::string>& words = {}) {
    const std::string text = Axle(kLeft, more + "\n");
    EXPECT_FALSE(Read(text).has_value());
    Expect(LineOf(text, more), kind, words);
  }
};

TEST_F(MirrorFaults, KnowTheEndsOfNames) {
  ExpectOnly(R"(<fp:mirror from="_lefft" to="_right"/>)", kMirrorNothing,
             {R"(from="_lefft" of <fp:mirror>)", "'_left'"});
}

TEST_F(MirrorFaults, NeedAnotherEnd) {
  ExpectOnly(R"(<fp:mirror from="_left" to="_left"/>)", kMirrorEnds, {R"(to="_left" of <fp:mirror>)"});
}

TEST_F(MirrorFaults, NeedAnEnd) {
  ExpectOnly(R"(<fp:mirror from="" to="_right"/>)", kAttributeEmpty, {R"(from="" of <fp:mirror>)"});
}

TEST_F(MirrorFaults, CountMirrors) {
  std::string mirrors;
  for (int i = 0; i < 8; ++i) mirrors += kMirror;
  const std::string ninth = R"(<fp:mirror  from="_left" to="_right"/>)";
  const std::string text = Axle(kLeft, mirrors + "\n" + ninth);
  EXPECT_FALSE(Read(text).has_value());
  Expect(LineOf(text, ninth), kMirrorCount, {"8"});
}

TEST_F(MirrorFaults, LeaveTwinsToTheirSide) {
  const std::string bind = R"(<fp:bind to="link[hub_right]/mass"/>)";
  const std::string text =
      Axle(kLeft, "<fp:parameter name=\"n\" value=\"20 kg\" source=\"test\">\n" + bind + "</fp:parameter>" + kMirror);
  EXPECT_FALSE(Read(text).has_value());
  Expect(LineOf(text, bind), kBindMirrored,
         {R"(to="link[hub_right]/mass" of <fp:bind>)", "fp:parameter 'n'", "link 'hub_left'"});
}

// The twin has it too.
TEST_F(MirrorFaults, AreToldOnceForTheOneThatIsWritten) {
  const std::string rod = R"(<fp:rod name="drop_left" parent="tip_left" child="ground"/>)";
  const std::string text = Axle(kLeft, rod + kMirror);
  EXPECT_FALSE(Read(text).has_value());
  Expect(LineOf(text, rod), kReferenceUnknown, {"fp:rod 'drop_left'", "link 'tip_left'"});
}

}  // namespace
}  // namespace fourpost::mirror_faults_test
