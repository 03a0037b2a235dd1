// On the wrong floor.
#pragma once
