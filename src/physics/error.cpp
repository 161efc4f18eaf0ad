#include "physics/error.hpp"

namespace plumbline::physics {

std::string_view to_text(ErrorStop stop) {
  switch (stop) {
    case ErrorStop::converged:
      return "converged";
    case ErrorStop::too_many_iterations:
      return "the machine stands too near a singularity: its error does not settle";
    case ErrorStop::singular:
      return "the pose is singular";
    case ErrorStop::fell_through:
      break;
  }
  return "the machine gives way through a singularity";
}

template TipError<double> tip_error(const ForceModel&, const double*, const Environment&, const Motion<double>&,
                                    const ErrorOptions&);

}  // namespace plumbline::physics
