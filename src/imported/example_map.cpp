// Maps to start from. What a control or an instrument writes is in them only where its layout is documented.
#include <fmt/format.h>

#include "base/text/nearest_name.hpp"
#include "imported/map_file.hpp"

namespace plumbline::imported {
namespace {

constexpr std::string_view kGeneral = R"(plumbline = "map 1"
machine = "my-machine"            # name of the model, goes into the dataset

[table]                           # how the files are written; every key may be left out
encoding = "auto"                 # or "utf-8", "utf-16le", "utf-16be", "latin-1"
delimiter = ";"                   # one character, "tab", or "blanks" for any number of them
decimal = ","                     # or "."
comment = ["#", "//"]             # lines that begin so are passed over
skip_lines = 0                    # lines at the top that are no part of the table
header = true                     # the next line names the columns; false: say column = 1, 2, ...
unit_lines = 0                    # lines below it, with units and the like
missing = ["", "NaN", "---"]      # what stands where there is no reading

[columns]                         # those that are there; each by name, or column = its number, counted from 1
time = {name = "Time", unit = "s"}                      # s, ms, us, min; or samples with period_s = 0.001
angle = {name = "Angle", unit = "deg"}                  # deg, rad: commanded, from +X towards +Y; sign = -1 turns it
# x = {name = "X", unit = "mm"}                         # or where the tip is, in W: x and y tell the angle
# y = {name = "Y", unit = "mm"}
radial = {name = "Deviation", unit = "um"}              # um, mm, m, inch, nm; sign = -1: inward counts positive there
# radial = {name = "Length", unit = "mm", minus = 150}  # a whole length: minus that of the bar
torque1 = {name = "M1", unit = "Nm"}                    # Nm, Nmm, Ncm; positive where the strut is pulled
torque2 = {name = "M2", unit = "Nm"}                    # all six, each from the column of that strut's motor, or none
torque3 = {name = "M3", unit = "Nm"}
torque4 = {name = "M4", unit = "Nm"}
torque5 = {name = "M5", unit = "Nm"}
torque6 = {name = "M6", unit = "Nm"}
# torque1 = {name = "M1", unit = "A", Nm_per_A = 0.85}  # a current, by the torque constant of the motor
# torque1 = {name = "M1", unit = "percent", rated_Nm = 12, sign = -1}

# [clock]
# motors_later_s = 0.12           # the motors' clock shows so much more than the bar's at the same moment

# [motors]                        # motors in files of their own: motors_file in each [[run]]; both need a time
# [motors.table]
# [motors.columns]

# [circle]
# samples = 360                   # readings averaged to so many a turn

[[run]]                           # one for each circle, as a dataset has it (docs/formats.md), and besides:
id = "01-ccw"
file = "circles.txt"              # the file that holds it; several runs may name the same one: its circles in turn
centre_mm = [0, 100, -1008]
radius_mm = 144
bar_mm = 150
tilt_deg = [0, 0, 0]
direction = "ccw"
feed_mm_min = 1000
# circle = 2                      # the second circle of the file
# run_in_deg = 180                # before the turn that is measured; if not said, as much as behind it
# start_angle_deg = 180           # where the first sample is, if only time tells the angle
)";

constexpr std::string_view kHalsampler = R"(plumbline = "map 1"
machine = "my-machine"
# LinuxCNC: halsampler -t > circle.samples. One line a sample, blanks between the values, no header; the number of the sample
# first, then the pins in the order of sampler's cfg; "overrun" on a line by itself where samples were lost  [halsampler(1)].
# Here cfg=ffffffff: X and Y of the tip, the torques of six drives.
preset = "linuxcnc-halsampler"

[columns]
time = {column = 1, unit = "samples", period_s = 0.001}   # of the thread that sampler runs in
x = {column = 2, unit = "mm"}
y = {column = 3, unit = "mm"}
torque1 = {column = 4, unit = "Nm"}
torque2 = {column = 5, unit = "Nm"}
torque3 = {column = 6, unit = "Nm"}
torque4 = {column = 7, unit = "Nm"}
torque5 = {column = 8, unit = "Nm"}
torque6 = {column = 9, unit = "Nm"}

[circle]
samples = 360

[[run]]
id = "01-ccw"
file = "circle.samples"
centre_mm = [0, 100, -1008]
radius_mm = 144
tilt_deg = [0, 0, 0]
direction = "ccw"
feed_mm_min = 1000
)";

}  // namespace

std::vector<std::string_view> example_names() { return {"general", "linuxcnc-halsampler"}; }

std::string_view example_map(std::string_view name) {
  if (name == "general") return kGeneral;
  if (name == "linuxcnc-halsampler") return kHalsampler;
  refuse("import-value", fmt::format("there is no example of a map called {}", name),
         suggestion(name, example_names()));
}

}  // namespace plumbline::imported
