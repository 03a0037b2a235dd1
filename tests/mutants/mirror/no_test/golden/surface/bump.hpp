// The definition is there.
#pragma once
