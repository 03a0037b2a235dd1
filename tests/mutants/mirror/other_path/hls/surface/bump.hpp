// rejected: mirror
// A unit that lies on another floor in the other tree.
#pragma once
