// latency_pkg: clocks of the pure pipelines that the engine lays side by side; the test of each unit asserts the number in its header.
package latency_pkg;
  localparam int unsigned Displace = 10;
  localparam int unsigned CalculateNewP = 4;
  localparam int unsigned CalculateNewU = 4;
  localparam int unsigned CalculateNewN = 25;
  localparam int unsigned ViewTest = 4;
  localparam int unsigned TexCoordTest = 2;
  localparam int unsigned VertexOrder = 2;
  localparam int unsigned ProfileLevels = 3;
  localparam int unsigned Bump = 31;
  localparam int unsigned NormalTest = 3;
  localparam int unsigned HighlightTest = 4;
  localparam int unsigned PassOrTessellate = 1;
  localparam int unsigned Transform = 32;
  localparam int unsigned TransformNormal = 6;
  localparam int unsigned ShorterDiagonal = 9;
endpackage
