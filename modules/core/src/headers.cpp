// The core is values and ports; this unit checks that its headers compile on their own.
#include <tencer/core/error.hpp>
#include <tencer/core/log.hpp>
#include <tencer/core/scale.hpp>
#include <tencer/core/version.hpp>
