#pragma once

#include <string>
#include <string_view>

#include "hsr/model.h"

namespace hsr::internal::read {

/// read_model() for who reads more formats than it does. @param more how the list of formats goes on in messages: ", STEP or IGES"
Model read_model_among(const std::string& path, const std::string& more);
Model read_model_among(const std::string& name, std::string_view bytes, const std::string& more);

}  // namespace hsr::internal::read
