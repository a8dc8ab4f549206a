(* ---------------------------------------------------------------------------------------------
   Which sensors at v0 suffice; one bit does.

     sufficient_at lambda d   as sufficient (Sensors.v), for worlds in which v0 has degree d.

     inadequate_twins     where the word for degree d is a proper power or blank there are two worlds that are
                          indistinguishable and different maps; no explorer finds both.
     degree_iff           for each d by itself, and  sensor_iff  for all: a sensor at v0 suffices if and
                          only if its words are primitive and not blank.
     door_suffices, door_minimal   the door, one bit, suffices, and nothing coarser does.
     directional_suffices, directional_not_minimal   the directional lighthouse does too, and is not minimal.
     position_fails       the position does not suffice.
     half_suffices, distance_suffices   the half does, and so does the distance.
     remainder_suffices   the bearing modulo q does at degree d unless q divides d, and is less.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps RootedMaps Indistinguishable Words Sensors SensorTwins.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Theorem 1 ---- *)
Definition sufficient_at A (lambda : sensor A) d := forall W W' : lighthouse_world, degree (@start W) = d ->
  indistinguishable lambda W W' -> isomorphic (rooted (@start W)) (rooted (@start W')).

Lemma blank_power u : 1 < size u -> blank u -> proper_power u.
Proof.
move=> s b; exists [:: 0], (size u); split=> //.
by elim: u b {s} => //= l u IH /andP[/eqP-> /IH {1}->].
Qed.

Theorem inadequate_twins w d : 0 < d -> proper_power (word w d) \/ blank (word w d) ->
  exists W W' : lighthouse_world,
  [/\ degree (@start W) = d, indistinguishable (at_v0 w) W W',
      ~ same_map (rooted (@start W)) (rooted (@start W'))
    & no_explorer_finds_both (M := rooted (@start W)) (N := rooted (@start W'))
        (percept_by (at_v0 w) (W := W)) (percept_by (at_v0 w) (W := W'))].
Proof.
move=> d0 H; have [W [W' [D I N]]] : exists W W' : lighthouse_world,
    [/\ degree (@start W) = d, indistinguishable (at_v0 w) W W' &
        ~ same_map (rooted (@start W)) (rooted (@start W'))].
  have pow : proper_power (word w d) -> exists W W' : lighthouse_world, [/\ degree (@start W) = d,
      indistinguishable (at_v0 w) W W' & ~ same_map (rooted (@start W)) (rooted (@start W'))].
    by case=> v [k [k1 E]]; have [W [W' [D _ _ I N]]] := power_twins d0 k1 E; exists W, W'.
  case: H => [/pow //|b]; case: d d0 b pow => [|[|d]] // _ b pow.
    by have [W [W' [D _ _ I N]]] := blank_twins b; exists W, W'.
  by apply: pow; apply: blank_power; rewrite ?size_mkseq.
exists W, W'; split=> // E meaning X [F F']; apply: N; have [R [Ro Rs Ra R0]] := I.
exact: (twins_same_map (M := rooted start) (N := rooted start) (R := R) Ro Rs Ra R0
  (rooted_wellformed _) F F').
Qed.

Lemma sufficient_at_adequate w d : 0 < d -> sufficient_at (at_v0 w) d -> adequate (word w d).
Proof.
move=> d0 S; have no : ~ (proper_power (word w d) \/ blank (word w d)).
  move=> H; have [W [W' [D I N _]]] := inadequate_twins d0 H; apply: N.
  exact: isomorphic_same_map (rooted_wellformed _) (S W W' D I).
by split=> [P|]; [apply: no; left | apply/negP=> b; apply: no; right].
Qed.

Theorem degree_iff w d : 0 < d -> sufficient_at (at_v0 w) d <-> adequate (word w d).
Proof.
move=> d0; split=> [|A W W' D I]; first exact: sufficient_at_adequate.
by rewrite -D in A; have [] := adequate_suffices A I.
Qed.

Theorem sensor_iff w : sufficient (at_v0 w) <-> forall d, 0 < d -> adequate (word w d).
Proof.
split=> [S d d0|A W W' I]; first by apply: sufficient_at_adequate => // W W' _; exact: S.
by have [] := adequate_suffices (A _ (degree_gt0 _)) I.
Qed.

(* ---- The door ---- *)
Theorem door_suffices : sufficient (at_v0 door_word).
Proof.
by apply/sensor_iff=> -[|d] // _; split; [exact: one_then_zeros_primitive | ].
Qed.

(* what is strictly coarser than the door gives both letters at some degree one letter: it is coarser than
   the door that is blank for this degree *)
Theorem door_minimal : minimal (at_v0 door_word).
Proof.
split=> [|B mu [C N] S]; first exact: door_suffices.
apply: N => G r x H s y D E; set d := degree x in D *.
have bit (K : combinatorial_map) (a z : K) : at_v0 door_word a z <= 1.
  by rewrite /at_v0; case: ifP => // _; exact: leq_b1.
apply/eqP; case: eqP => // ne; pose w e b := if e == d then 0 else door_word e b.
have one (K : combinatorial_map) (a z : K) : degree z = d -> mu K a z = mu G r x.
  move=> Dz; have [Z|Z] : at_v0 door_word a z = at_v0 door_word r x \/
      at_v0 door_word a z = at_v0 door_word s y.
    move: (bit K a z) (bit G r x) (bit H s y) ne.
    case: (at_v0 _ a z) => [|[|l]] // _; case: (at_v0 _ r x) => [|[|l]] // _;
      case: (at_v0 _ s y) => [|[|l]] //; auto.
    exact: C.
  by rewrite E; apply: C => //; rewrite Dz.
have Cw : coarser mu (at_v0 w).
  move=> K a z K' a' z' Dz Ez; case: (degree z =P d) => [Dd|/eqP nd]; first by rewrite !one // -Dz.
  by apply: C => //; move: Ez; rewrite /at_v0 /w -Dz (negbTE nd).
have [_ /negP[]] := (sensor_iff w).1 (sufficient_finer Cw S) d (degree_gt0 x).
by apply/(all_nthP 0) => b; rewrite size_mkseq => lt; rewrite nth_mkseq // /w eqxx.
Qed.

(* ---- The directional lighthouse, and position ---- *)
Theorem directional_suffices : sufficient (at_v0 directional_word).
Proof. by apply/sensor_iff=> -[|d] // _; split; [exact: counting_primitive |]. Qed.

Theorem door_strictly_coarser : strictly_coarser (at_v0 door_word) (at_v0 directional_word).
Proof.
split=> [G r x H s y D|C].
  by rewrite /at_v0 /directional_word /door_word; case: ifP => _; case: ifP => _ // -[->].
pose W := flower 0 (ord0 : in_turn 2); pose z k : W := iter k sigma pointed.
have D k : degree (z k) = 3.
  by rewrite (degree_same (fconnect_iter _ _ _)) stem_degree ?card_ord //; exact: onward_reaches.
have turn k : k <= 3 -> iter k sigma (z (3 - k)) = pointed.
  by move=> le; rewrite /z -iterD subnKC // -(D 0) iter_degree.
have L w k : 0 < k < 3 -> at_v0 w pointed (z (3 - k)) = w 3 k.
  by case/andP=> _ lt; rewrite (letter_turn w (turn _ (ltnW lt))) D modn_small.
by have := C W pointed (z 2) W pointed (z 1); rewrite !D !(L _ 1) // !(L _ 2) // => /(_ erefl erefl).
Qed.

Theorem directional_not_minimal : ~ minimal (at_v0 directional_word).
Proof. by case=> _ /(_ _ _ door_strictly_coarser); apply; exact: door_suffices. Qed.

Theorem position_fails : ~ sufficient (at_v0 position_word).
Proof. by move/sensor_iff=> /(_ 2 isT)[P _]; apply: P; exists [:: 1], 2. Qed.

(* ---- Others ---- *)
Theorem half_suffices : sufficient (at_v0 half_word).
Proof. by apply/sensor_iff=> -[|d] // _; split; [exact: halves_primitive | rewrite /blank /=]. Qed.

Theorem distance_suffices : sufficient (at_v0 distance_word).
Proof. by apply/sensor_iff=> -[|d] // _; split; [exact: distances_primitive |]. Qed.

Theorem remainder_suffices q d : 0 < q -> 0 < d ->
  sufficient_at (at_v0 (remainder_word q)) d <-> ~~ ((q %| d) && (q < d)).
Proof.
move=> q0 d0; rewrite degree_iff // -remainders_primitive //.
by split=> [[]|P] //; split=> //; case: d d0 {P}.
Qed.
