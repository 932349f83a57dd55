#include "core/config/serverconfig.h"
