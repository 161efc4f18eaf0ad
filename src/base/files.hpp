// Files: input that can be sought in, output that appears whole or not at all.
#pragma once

#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/output_set.hpp"
