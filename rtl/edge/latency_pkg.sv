// latency_pkg: clocks of the pure pipelines that the engine lays side by side. The test of each unit asserts the number; ProfileLevels and
// ShorterDiagonal are parts of profile_test and tessellate, whose words are wrong with any other number.
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
  // The same where three clocks a vertex let what they are made of take turns.
  localparam int unsigned BumpInTurns = 34;
  localparam int unsigned HighlightTestInTurns = 7;
  localparam int unsigned TransformInTurns = 35;
  localparam int unsigned TransformNormalInTurns = 8;
  localparam int unsigned ShorterDiagonal = 9;

  // Of a lane's stages, with 1 or 3 clocks a vertex: normals and tangents take turns, and what follows N'.
  function automatic int unsigned new_vertex(int unsigned clocks);
    return CalculateNewN + (clocks == 1 ? 0 : 1);
  endfunction
  function automatic int unsigned bump(int unsigned clocks);
    return clocks == 1 ? Bump : BumpInTurns;
  endfunction
  function automatic int unsigned highlight_test(int unsigned clocks);
    return clocks == 1 ? HighlightTest : HighlightTestInTurns;
  endfunction
  function automatic int unsigned transform(int unsigned clocks);
    return clocks == 1 ? Transform : TransformInTurns;
  endfunction
  function automatic int unsigned transform_normal(int unsigned clocks);
    return clocks == 1 ? TransformNormal : TransformNormalInTurns;
  endfunction
  function automatic int unsigned longer(int unsigned a, int unsigned b);
    return a > b ? a : b;
  endfunction
  function automatic int unsigned edge_back(int unsigned clocks);
    return longer(
        bump(clocks) + longer(
            longer(NormalTest, highlight_test(clocks)) + PassOrTessellate, transform_normal(clocks)
        ),
        transform(clocks)
    );
  endfunction
endpackage
