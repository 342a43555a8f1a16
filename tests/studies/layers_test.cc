// SPDX-License-Identifier: LGPL-2.1-or-later
#include <catch2/catch.hpp>
#include <cstdlib>

TEST_CASE("the check of the layers finds planted violations")
{
  REQUIRE(std::system(BALLONET_SOURCE_DIR "/scripts/check_layers.py --self-test") == 0);
}
