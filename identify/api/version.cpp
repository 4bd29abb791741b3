#include <fourpost/version.h>

namespace fourpost::api {

std::string Version() { return FOURPOST_VERSION; }

}  // namespace fourpost::api
