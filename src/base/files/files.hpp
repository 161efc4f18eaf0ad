// Files: input that can be sought in, output that appears whole or not at all.
#pragma once

#include "base/files/input_file.hpp"
#include "base/files/output_file.hpp"
#include "base/files/output_set.hpp"
