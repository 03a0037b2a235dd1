// triangle_queue: where triangles wait for their next pass, without a deadlock.
//   contract: hls/edge/triangle_queue.hpp; Doggett & Hirche 2000, section 3, Triangle Queue
//
//   parameters  T;  Depth entries, at least 3 max_generation + 4;  InFlight, the most triangles in flight at once
//               FifoReserve  slack below which fifo mode takes the newest. With 0 it does so only where nothing else is allowed, one
//               triangle at a time, as the kernel does; with four for every triangle in flight, the queue turns depth first before it
//               is full, and keeps its pace
//   in    max_generation_i  M, like regs_i constant from reset, or from four clocks before a base triangle is taken, until idle
//         push_*            a child of a triangle in flight; one a clock, never refused
//         retire_i          a triangle in flight is dealt with and its children, four at most, are pushed, the last one in this clock
//                           at the latest
//         take_i            a base triangle came from outside and is in flight from now on; only where may_take_o
//   out   pop_*             the next triangle; up to three are read ahead
//         count_o           entries held; in_flight_o  triangles popped or taken and not retired, those read ahead among them
//         high_water_o      the largest count; fallbacks_o  pops that fifo mode took from the newest end; both since reset
//         idle_o            nothing held and nothing in flight;  error_o  a push met a full queue: nothing that follows means anything
//
//   latency 3 from a push into an empty queue to pop_valid_o; initiation interval 1: one pop and one push a clock
//   registered: all outputs; pop_ready_i reaches registers alone
//
//   push --[memory]--[read]--[next]--[head]-- pop       lifo: the newest; fifo: the oldest while slack >= FifoReserve, else the newest
//
// The credit rule, with F free entries and k triangles in flight, in numbers as they are at the beginning of a clock:
//   a pop at any time where   slack = F + 1 - 4 (k + 1) - 3 M >= 0,
//   a base triangle where     F - 4 (k + 1) - 3 M >= 0, that is, slack >= 1,
//   and where slack is negative a pop when nothing is in flight.
// slack is kept as one register: a push takes 1 from it, a pop 3, a base triangle 4, a retirement gives 4. So the rule is its sign, and
// nothing of it has to be guessed a clock early. A base triangle and a pop may fall into one clock, and may_take_o is a register that
// knows slack of a clock ago: it wants slack >= 12, or an idle queue.
//
// It never fills. Let R be the longest path of splits below a triangle: M or less, and a child has one less than its parent. An entry
// with h - 1 entries before it (nearer to the oldest end) has height h. Two things hold at all times:
//   (1) h + 3 R <= Depth for every entry;
//   (2) while more than one triangle, or one that the rule let go freely, is in flight: F - E >= 3 M, where E <= 4 k is the number of
//       children that those in flight may still push.
//   A free pop or a base triangle leaves F - 4 k >= 3 M by the rule, and E <= 4 k: (2). A push takes one from F and one from E, and a
//   retirement only takes from E: (2) stays. A push under (2) has E >= 1, so F >= 3 M + 1 before it, and afterwards every entry, wherever
//   the new one went among them, has h <= Depth - 3 M: (1).
//   A pop when nothing is in flight takes the newest, at height h, and nothing else moves until it is retired: with slack negative at k = 0
//   it stays so at k = 1. If R = 0 it pushes nothing, else its children come to h .. h + 3 at most with R - 1, and
//   h + 3 + 3 (R - 1) = h + 3 R <= Depth: (1), and there is room for them.
//   Pops from either end only lower heights.
// Nothing hangs. What is in flight needs nothing from here but that its children are taken, and they are; so all of it retires. With
// nothing in flight there is a pop if anything is held, and if not, F = Depth >= 3 M + 4 gives slack >= 1: a base triangle may be taken.
// Each base triangle has finitely many triangles below it.
//
// Newest end: the newest word lies at one of two neighbouring places, x and x + 1, and the next goes to the other one. A push alone
// moves both up, a pop alone both down, a pop with a push exchanges them: a place is never read and written in the same clock, so any
// block memory will do. (An exchange puts the next word below its elder; only with others in flight, where the order is free. Nothing in
// flight: the first to come is a pop, which undoes it, or a base triangle, whose children meet (2).)
module triangle_queue
  import formats_pkg::*;
  import edge_pkg::*;
#(
  parameter type T = logic [31:0],
  parameter int unsigned Depth = 64,
  parameter int unsigned InFlight = Depth,
  parameter int unsigned FifoReserve = 0,
  localparam int unsigned CountBits = $clog2(Depth + 1)
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  input  triangle_queue_regs_t regs_i,
  input  generation_t          max_generation_i,
  input  logic                 push_valid_i,
  input  T                     push_i,
  output logic                 pop_valid_o,
  input  logic                 pop_ready_i,
  output T                     pop_o,
  input  logic                 retire_i,
  input  logic                 take_i,
  output logic                 may_take_o,
  output logic [CountBits-1:0] count_o,
  output logic [CountBits-1:0] in_flight_o,
  output logic [15:0]          high_water_o,
  output logic [63:0]          fallbacks_o,
  output logic                 idle_o,
  output logic                 error_o
);
  if (Depth < 4 || Depth > 65535) begin : gen_depth
    $error("Depth is 4 to 65535");
  end
  localparam int unsigned PlaceBits = $clog2(Depth);
  // From -4 Depth to Depth.
  localparam int unsigned SlackBits = CountBits + 4;
  typedef logic [PlaceBits-1:0] place_t;
  typedef logic signed [SlackBits-1:0] slack_t;

  function automatic place_t up(place_t place);
    return place == place_t'(Depth - 1) ? '0 : place + place_t'(1);
  endfunction
  function automatic place_t down(place_t place);
    return place == '0 ? place_t'(Depth - 1) : place - place_t'(1);
  endfunction

  // ---- the credit rule
  logic [CountBits-1:0] count_q, in_flight_q;
  logic                 alone_q;  // nothing is in flight
  logic                 below_q;  // fewer than InFlight are in flight, whatever happens in a clock
  logic                 idle_q, may_take_q;
  slack_t               slack_q, start_q;
  logic                 free_running, oldest, pop, push, refused;
  logic           [1:0] ahead_q;  // triangles read ahead

  assign free_running = !slack_q[SlackBits-1];
  assign oldest = regs_i.fifo && slack_q >= slack_t'(FifoReserve);
  // In fifo mode the two newest places keep their order, so the newest end takes a push or a pop in a clock.
  assign pop = count_q != '0 && ahead_q != 2'd3 && (alone_q || (free_running && below_q)) &&
      !(regs_i.fifo && !oldest && push_valid_i);
  assign refused = push_valid_i && count_q == CountBits'(Depth);
  assign push = push_valid_i && !refused;

  slack_t change;
  always_comb begin
    unique case ({retire_i, take_i, pop, push})
      4'b0001: change = -slack_t'(1);
      4'b0010: change = -slack_t'(3);
      4'b0011: change = -slack_t'(4);
      4'b0100: change = -slack_t'(4);
      4'b0101: change = -slack_t'(5);
      4'b0110: change = -slack_t'(7);
      4'b0111: change = -slack_t'(8);
      4'b1000: change = slack_t'(4);
      4'b1001: change = slack_t'(3);
      4'b1010: change = slack_t'(1);
      4'b1101: change = -slack_t'(1);
      4'b1110: change = -slack_t'(3);
      4'b1111: change = -slack_t'(4);
      default: change = '0;
    endcase
  end

  always_ff @(posedge clk_i) begin
    start_q <= slack_t'(Depth - 3)
             - (slack_t'(max_generation_i) + slack_t'({max_generation_i, 1'b0}));
    if (!rst_ni) begin
      count_q <= '0;
      in_flight_q <= '0;
      alone_q <= 1'b0;
      below_q <= 1'b0;
      idle_q <= 1'b1;
      may_take_q <= 1'b0;
      slack_q <= '1;
      error_o <= 1'b0;
    end else begin
      count_q <= count_q + CountBits'(push) - CountBits'(pop);
      in_flight_q <= in_flight_q + CountBits'(pop) + CountBits'(take_i) - CountBits'(retire_i);
      slack_q <= idle_q && !take_i ? start_q : slack_q + change;
      // Both are a clock late, and true only where they still are.
      alone_q <= in_flight_q == '0 && !pop && !take_i;
      idle_q <= in_flight_q == '0 && count_q == '0 && !take_i;
      below_q <= 32'(in_flight_q) + 32'd4 <= InFlight;
      may_take_q <= (slack_q >= slack_t'(12) && 32'(in_flight_q) + 32'd4 <= InFlight)
                 || (slack_q >= slack_t'(1) && idle_q && !take_i);
      if (refused) error_o <= 1'b1;
    end
  end

  // ---- the places
  logic   exchanged_q;
  place_t low_q, high_q, first_q, read_place, write_place;

  assign write_place = exchanged_q ? low_q : high_q;
  assign read_place = oldest ? first_q : exchanged_q ? high_q : low_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      exchanged_q <= 1'b0;
      low_q <= place_t'(Depth - 1);
      high_q <= '0;
      first_q <= '0;
    end else begin
      if (pop && oldest) first_q <= up(first_q);
      if (pop && !oldest && push) begin
        exchanged_q <= !exchanged_q;
      end else if (push) begin
        exchanged_q <= 1'b0;
        low_q <= high_q;
        high_q <= up(high_q);
      end else if (pop && !oldest) begin
        exchanged_q <= 1'b0;
        low_q <= down(low_q);
        high_q <= low_q;
      end
    end
  end

  // No place is read and written in one clock, so nothing has to be built around the memory for it.
  (* no_rw_check *) T memory_q [Depth];
  T read_q;
  always_ff @(posedge clk_i) begin
    if (push) memory_q[write_place] <= push_i;
    if (pop) read_q <= memory_q[read_place];
  end

  // ---- read ahead: read_q moves on unless next and head are both taken, and a pop is begun only where it will
  T     next_q, head_q;
  logic read_valid_q, next_valid_q, head_valid_q;
  logic leave, to_head, move;
  assign leave = head_valid_q && pop_ready_i;
  assign to_head = leave || !head_valid_q;
  assign move = read_valid_q && !(head_valid_q && next_valid_q);
  always_ff @(posedge clk_i) begin
    if (to_head) head_q <= next_valid_q ? next_q : read_q;
    if (move) next_q <= read_q;
    if (!rst_ni) begin
      ahead_q <= '0;
      read_valid_q <= 1'b0;
      next_valid_q <= 1'b0;
      head_valid_q <= 1'b0;
    end else begin
      ahead_q <= ahead_q + 2'(pop) - 2'(leave);
      read_valid_q <= pop || (read_valid_q && !move);
      head_valid_q <= !to_head || next_valid_q || move;
      next_valid_q <= !to_head && (next_valid_q || move);
    end
  end

  // ---- counters
  logic [15:0] high_water_q;
  logic [63:0] fallbacks_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      high_water_q <= '0;
      fallbacks_q <= '0;
    end else begin
      if (16'(count_q) > high_water_q) high_water_q <= 16'(count_q);
      if (pop && regs_i.fifo && !oldest) fallbacks_q <= fallbacks_q + 64'd1;
    end
  end

  assign pop_valid_o = head_valid_q;
  assign pop_o = head_q;
  assign may_take_o = may_take_q;
  assign count_o = count_q;
  assign in_flight_o = in_flight_q;
  assign high_water_o = high_water_q;
  assign fallbacks_o = fallbacks_q;
  assign idle_o = idle_q;

  // What must hold in every simulation; the first is what the proof above is about, the others are the other side's.
  logic early, unasked, exchanged;
  assign early = take_i && !may_take_q;
  assign unasked = (push_valid_i || retire_i) && in_flight_q == '0;
  assign exchanged = exchanged_q && regs_i.fifo;
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!refused) else $error("triangle_queue: a push on a full queue");
      assert (!early) else $error("triangle_queue: a base triangle taken too early");
      assert (!unasked) else $error("triangle_queue: a push or a retirement, nothing in flight");
      assert (!exchanged) else $error("triangle_queue: places exchanged in fifo mode");
    end
  end
endmodule
