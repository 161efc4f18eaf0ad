// The effects that there are. A new one is a file beside this one, an include and a line in the second list.
//
// An effect is a struct with a static `name`, a static table `parameters` and any of the hooks of physics/hooks.hpp,
// each of which adds to `sum` and assigns nothing. Zero parameters change nothing.
#pragma once

#include <tuple>

#include "physics/effects/axial_elasticity.hpp"
#include "physics/effects/backlash.hpp"
#include "physics/effects/base_joint_compliance.hpp"
#include "physics/effects/cable.hpp"
#include "physics/effects/centre_of_mass.hpp"
#include "physics/effects/contact_compliance.hpp"
#include "physics/effects/counterbalance.hpp"
#include "physics/effects/cyclic.hpp"
#include "physics/effects/frame_compliance.hpp"
#include "physics/effects/generic.hpp"
#include "physics/effects/gimbal_offset.hpp"
#include "physics/effects/inertia.hpp"
#include "physics/effects/joint_clearance.hpp"
#include "physics/effects/joint_coulomb.hpp"
#include "physics/effects/joint_friction.hpp"
#include "physics/effects/joint_position.hpp"
#include "physics/effects/joint_viscous.hpp"
#include "physics/effects/known_loads.hpp"
#include "physics/effects/lead_error.hpp"
#include "physics/effects/level.hpp"
#include "physics/effects/load_friction.hpp"
#include "physics/effects/payload.hpp"
#include "physics/effects/platform_gravity.hpp"
#include "physics/effects/platform_joint_compliance.hpp"
#include "physics/effects/platform_mass.hpp"
#include "physics/effects/residual.hpp"
#include "physics/effects/ring_thermal.hpp"
#include "physics/effects/screw_coulomb.hpp"
#include "physics/effects/screw_friction.hpp"
#include "physics/effects/screw_roll.hpp"
#include "physics/effects/screw_stribeck.hpp"
#include "physics/effects/screw_viscous.hpp"
#include "physics/effects/servo_lag.hpp"
#include "physics/effects/servo_mismatch.hpp"
#include "physics/effects/spindle_growth.hpp"
#include "physics/effects/strut_compliance.hpp"
#include "physics/effects/strut_gravity.hpp"
#include "physics/effects/strut_mass.hpp"
#include "physics/effects/strut_offset.hpp"
#include "physics/effects/thermal_drift.hpp"
#include "physics/effects/torque_scale.hpp"

namespace plumbline::physics {

/// Always there; their parameters are keys of the model file's own tables.
using BaseEffects = std::tuple<PlatformGravity,  //
                               StrutGravity,     //
                               KnownLoads,       //
                               ScrewFriction,    //
                               JointFriction,    //
                               AxialElasticity>;

/// There when an [[effect]] row of the model file, or whoever fits a model, puts them there.
using CatalogueEffects = std::tuple<Payload,                  //
                                    PlatformMass,             //
                                    CentreOfMass,             //
                                    Level,                    //
                                    StrutMass,                //
                                    ScrewCoulomb,             //
                                    ScrewViscous,             //
                                    ScrewStribeck,            //
                                    LoadFriction,             //
                                    JointCoulomb,             //
                                    JointViscous,             //
                                    Backlash,                 //
                                    StrutOffset,              //
                                    ThermalDrift,             //
                                    Cyclic,                   //
                                    ServoLag,                 //
                                    ServoMismatch,            //
                                    TorqueScale,              //
                                    BaseJointCompliance,      //
                                    PlatformJointCompliance,  //
                                    StrutCompliance,          //
                                    JointClearance,           //
                                    Cable,                    //
                                    Inertia,                  //
                                    Counterbalance,           //
                                    LeadError,                //
                                    RingThermal,              //
                                    JointPosition,            //
                                    GimbalOffset,             //
                                    ScrewRoll,                //
                                    SpindleGrowth,            //
                                    FrameCompliance,          //
                                    ContactCompliance,        //
                                    Generic,                  //
                                    Residual>;

using Effects = decltype(std::tuple_cat(BaseEffects{}, CatalogueEffects{}));
inline constexpr std::size_t kBaseEffects = std::tuple_size_v<BaseEffects>;
inline constexpr std::size_t kEffects = std::tuple_size_v<Effects>;

}  // namespace plumbline::physics
