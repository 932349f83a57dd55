#include "core/config/inifile.h"
