#include "nc/control/families/called_values.hpp"

#include <algorithm>
#include <iterator>

namespace plumbline::nc {
namespace {

constexpr double kLeastShare = 0.001;  // of the feed, FRF [C 2.1.4]
constexpr int kFirstDepth = 5, kFirstRelativeDepth = 6, kFirstShare = 10, kKindOfDeep = 11, kModesOfDeep = 19;
constexpr double kSameDepth = 1e-9;  // mm

constexpr Places kPlaces[] = {
    {kCalledDrill, 8, -1, -1, -1, -1},
    {kCalledDrillDwell, 8, 6, 7, 8, -1},
    {kCalledDeep, 19, 17, 18, kModesOfDeep, 12, true},
    {kCalledTap, 23, -1, 22, 23, 12, true},
    {kCalledReam, 10, -1, 9, 10, -1, true},
    {kCalledBore, 13, -1, 12, 13, -1, true},
    {kCalledBoreStop, 5, -1, -1, -1, -1, true},
    {kCalledBoreByHand, 6, -1, -1, -1, -1, true},
    {kCalledBoreDwell, 8, -1, 7, 8, -1},
    {kCalledFloatingTap, 19, -1, 18, 19, 11, true},
};

// A digit of the last value of CYCLE83 (_AMODE).
int mode_digit(const CalledValues& given, long unit) {
  return static_cast<int>(std::labs(std::lround(given.number(kModesOfDeep))) / unit % 10);
}

}  // namespace

// Nine values of CYCLE81 fit one order alone: that of newer controls, with a dwell after the depth as CYCLE82 has it (a
// post for the 828D writes them so).
Places places_of(const CycleCall& call) {
  const Places places = *std::find_if(std::begin(kPlaces), std::end(kPlaces),
                                      [&](const Places& of) { return of.code == call.row->value; });
  constexpr std::size_t kWithDwell = 9;
  if (places.code != kCalledDrill || call.arguments.size() != kWithDwell) return places;
  return {kCalledDrill, 8, 6, 7, 8, -1};
}

double pitch_of_thread(double diameter) {
  constexpr std::pair<int, double> kCoarse[] = {{3, 0.5},   {4, 0.7},  {5, 0.8},  {6, 1},    {8, 1.25}, {10, 1.5},
                                                {12, 1.75}, {14, 2},   {16, 2},   {18, 2.5}, {20, 2.5}, {22, 2.5},
                                                {24, 3},    {27, 3},   {30, 3.5}, {33, 3.5}, {36, 4},   {39, 4},
                                                {42, 4.5},  {45, 4.5}, {48, 5}};
  for (const auto& [size, pitch] : kCoarse) {
    if (std::abs(diameter) == size) return pitch;
  }
  return 0;
}

double first_depth_mm(const CalledValues& given) {
  const double below = std::abs(given.length_mm(kFirstRelativeDepth));
  const double by_level = given.length_mm(kReferencePlane) - given.length_mm(kFirstDepth);
  const bool has_level = given.number(kFirstDepth) != 0;
  if (has_level && by_level < 0) {
    given.refuse("its first depth lies above its reference plane", "give the first depth below it");
  }
  if (has_level && below != 0 && std::abs(below - by_level) > kSameDepth) {
    given.refuse("its two first depths contradict each other", "leave out one of FDEP and FDPR");
  }
  const double first = has_level ? by_level : below;
  if (first != 0) return first;
  given.refuse("no source says how deep it goes without a first depth",
               "give FDEP or FDPR, its sixth and seventh values");
}

bool breaks_chips(const CalledValues& given) {
  const double kind = given.number(kKindOfDeep);
  if (kind == 0 || kind == 1) return kind == 0;
  given.refuse("no source says what its kind of work is", "give VARI, its twelfth value, as 0 or 1");
}

// Posts write 1 where the eighth digit of _AMODE is left out, and 100 where it is 1.
double first_share(const CalledValues& given) {
  constexpr long kUnitOfShare = 10000000;
  const double written = given.number(kFirstShare);
  if (written == 0) {
    given.refuse("no source says what its first feed is without its factor (FRF, the eleventh value)",
                 "write FRF as 1, where the first stroke is to go at F");
  }
  const int unit = mode_digit(given, kUnitOfShare);
  const double share = unit == 1 ? written / 100 : written;
  if (unit <= 1 && share >= kLeastShare && share <= 1) return share;
  given.refuse("no source says what its factor of the first feed means", "write FRF from 0.001 to 1, or leave it out");
}

double dwell_of_deep_hole(const CalledValues& given, int place, long unit) {
  const double dwell = given.number(place);
  if (dwell != 0 && mode_digit(given, unit) > 1) {
    given.refuse("its last value asks for a dwell in turns of the spindle, which is not interpreted",
                 "give the dwell in seconds, and 0 or 1 as that digit of the value");
  }
  return dwell;
}

}  // namespace plumbline::nc
