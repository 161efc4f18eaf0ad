// The machine that a control with LinuxCNC's kinematics for hexapods believes it has.
#pragma once

#include <string>
#include <vector>

#include "jobs/new_model/linuxcnc_control_files.hpp"
#include "jobs/new_model/model_draft.hpp"

namespace plumbline::jobs {

/// Puts into the draft what the files state: name, joints, home, and those limits that limit anything (a strut has no
/// length below zero, and no strut takes the tip further than twice its length). Where the draft states home or a limit
/// already, that stays, and is not compared with the files. `notes` gets what was read and what was left out. Refuses
/// with draft-missing, draft-number, and with draft-contradiction struts whose lengths at HOME of [TRAJ]
/// are not HOME of their joints.
void take_linuxcnc(const LinuxcncControl& control, ModelDraft& draft, std::vector<std::string>& notes);

}  // namespace plumbline::jobs
