// A control's files for a hexapod, as a test changes them.
#pragma once

#include <string>

#include "jobs/new_model/new_model.hpp"
#include "support/scratch.hpp"

namespace plumbline::testing {

/// Joints on two circles, in mm; the struts are 1170.47 mm long at HOME.
inline std::string hal_text() {
  return "loadrt [KINS]KINEMATICS\n# the joints\n"
         "setp genhexkins.base.0.x 1000\nsetp genhexkins.base.0.y -50\nsetp genhexkins.base.0.z 0\n"
         "setp genhexkins.base.1.x 1000\nsetp genhexkins.base.1.y 50\nsetp genhexkins.base.1.z 0\n"
         "setp genhexkins.base.2.x -460\nsetp genhexkins.base.2.y 890\nsetp genhexkins.base.2.z 0\n"
         "setp genhexkins.base.3.x -540\nsetp genhexkins.base.3.y 840\nsetp genhexkins.base.3.z 0\n"
         "setp genhexkins.base.4.x -540\nsetp genhexkins.base.4.y -840\nsetp genhexkins.base.4.z 0\n"
         "setp genhexkins.base.5.x -460\nsetp genhexkins.base.5.y -890\nsetp genhexkins.base.5.z 0\n"
         "setp genhexkins.platform.0.x 180\nsetp genhexkins.platform.0.y -240\nsetp genhexkins.platform.0.z 100\n"
         "setp genhexkins.platform.1.x 180\nsetp genhexkins.platform.1.y 240\nsetp genhexkins.platform.1.z 100\n"
         "setp genhexkins.platform.2.x 120\nsetp genhexkins.platform.2.y 275\nsetp genhexkins.platform.2.z 100\n"
         "setp genhexkins.platform.3.x -300\nsetp genhexkins.platform.3.y 35\nsetp genhexkins.platform.3.z 100\n"
         "setp genhexkins.platform.4.x -300\nsetp genhexkins.platform.4.y -35\nsetp genhexkins.platform.4.z 100\n"
         "setp genhexkins.platform.5.x 120\nsetp genhexkins.platform.5.y -275\nsetp genhexkins.platform.5.z 100\n";
}

inline std::string ini_text() {
  return "[EMC]\nMACHINE = bench hexapod\n[KINS]\nKINEMATICS = genhexkins\nJOINTS = 6\n"
         "[HAL]\nHALFILE = LIB:basic_sim.tcl\nHALFILE = joints.hal\n"
         "[TRAJ]\nLINEAR_UNITS = mm\nHOME = 0 0 800 0 0 0\n"
         "[AXIS_Z]\nMIN_LIMIT = 700\nMAX_LIMIT = 900\n";
}

/// The first place of `what` in a text, replaced; what is not there is a fault of the test.
inline std::string with(std::string text, const std::string& what, const std::string& in_its_place) {
  return text.replace(text.find(what), what.size(), in_its_place);
}

/// Writes both files; the job that reads them.
inline jobs::NewModelJob job_of(const Scratch& scratch, const std::string& ini, const std::string& hal) {
  scratch.file("joints.hal", hal);
  jobs::NewModelJob job;
  job.control = jobs::ControlFiles{scratch.file("hexapod.ini", ini), {}};
  return job;
}

}  // namespace plumbline::testing
