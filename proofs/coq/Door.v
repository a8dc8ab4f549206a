(* ---------------------------------------------------------------------------------------------
   An explorer for the door: Algorithm 1 with one bit.                             Sections IV and VIII

   The robot senses the degree, and 1 where it has come in by the marked door, else 0: nothing tells v0 from
   other vertices.  A hypothesis is tested by walking to v0 in S, as before, and then out by the door and
   back: the bit is 1 if and only if the hypothesis is true.  Before the first pass the robot looks for
   the door, out and back by one dart of v0 after the other.

     door_percept d       what is sensed: the degree and the bit (percept_by of Sensors.v).
     rings o              the bit is 1.
     seen_of o            of a percept with a bearing: the degree, and whether the bearing is 0.
     seek n k left o      o is sensed in dart k of v0, which has n darts: if it is the door, set out; else
                          try the next one, as long as any are left.
     door, door_algorithm pol   the lighthouse, for the program, and the explorer.
     rung S f y           out by the dart that should be the door, if the robot is at f, and back to y: it
                          rings.
     door_bound W         (1)+(2) and two traversals for each test, 2 m^2 in all.
     door_sum n m         (1)+(2) with n_s in place of n_s - 1 and n in place of n - 1 in the second factors.

     rung_iff             a test rings if and only if its hypothesis is true.
     door_runs            for every schedule: what Lighthouses.v says.
     door_correct         the explorer, under every policy, with any budget of at least door_bound and twice
                          the first bearing, 2 (deg(v0) - 1) at most: it stops within that, and is right.
     door_bound_sum       door_bound is 2 m less than door_sum.
   --------------------------------------------------------------------------------------------- *)
From Coq Require Import Lia.
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers PartialMaps HypothesisTests.
From Allworlds Require Import Pass Cost Correctness PassCounts Lighthouses Algorithm Queue Execution OnePass.
From Allworlds Require Import Refinement Sensors.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- The program ---- *)
Definition rings (o : nat * nat) := o.2 == 1.
Definition seen_of (o : percept) : nat * nat := (o.1, o.2 == Some 0 : nat).

Fixpoint seek n k left (o : nat * nat) : program (nat * nat) knowledge :=
  if rings o then Return (knowledge_at_v0 n k (opposite n k)) else
  if left is left'.+1 then Go 1 (fun _ => Go 0 (seek n k.+1 left')) else Return (knowledge_at_v0 n 0 0).

Definition door_query k f := odflt 0 (expected_percept (bearing0 k) (known_map k) f).2.

Definition door : lighthouse (nat * nat) [eqType of nat] :=
  {| set_out := fun o => seek o.1 0 o.1 o;
     reads := id;
     foretells := seen_of;
     confirm := fun k f c => Go (c + door_query k f) (fun _ => Go 0 (fun o =>
       Return (rings o, opposite (degree_in (known_map k) f.1) (door_query k f)))) |}.
Definition door_algorithm := explorer_by door.

(* ---- In a world ---- *)
Section InWorld.
Variable W : lighthouse_world.
Local Notation v0 := (@start W).
Local Notation b := (first_bearing W).
Local Notation embedded := (@embedded W v0).
Local Notation phi := (@phi W v0).
Local Notation n := (vertices W).
Local Notation m := (edges W).

Definition door_percept : W -> nat * nat := percept_by (at_v0 door_word) (W := W).
Definition door_bound := paper_bound n m + 2 * m ^ 2.

Lemma bearing_0 (d : W) : (bearing d == Some 0) = (d == pointed).
Proof.
apply/eqP/eqP=> [|->]; rewrite /bearing; last by rewrite /at_same_vertex connect0 findex0.
by case: ifP => // c [E]; rewrite -(iter_findex c) E.
Qed.

Lemma door_seen (d : W) : door_percept d = seen_of (percept_of d).
Proof.
rewrite /door_percept /percept_by letter_of_bearing /seen_of /percept_of /=; congr (_, _).
by case: (bearing d).
Qed.

Lemma rings_at (d : W) : rings (door_percept d) = (d == pointed).
Proof. by rewrite door_seen /rings /seen_of /= bearing_0; case: (d == pointed). Qed.

Definition rung S f (y : W) :=
  rings (door_percept (motion 0 (motion (odflt 0 (expected_percept b S f).2) y))).

Theorem rung_iff S r h w f (x : W) : embedded S r -> known S h -> follow S w h = Some f ->
  f.1 = 0 -> matches seen_of rung S x (h, w) f <-> x = phi r h.
Proof.
move=> I kh R f0; have [kf E] := follow_phi I kh R; rewrite /matches /rung.
set q := odflt 0 _; have at_door : iter q sigma (phi r f) = pointed.
  have := expected_percept_phi I kf; rewrite /q /expected_percept f0 /= => -[_].
  by rewrite /bearing; case: ifP => // c [->]; exact: iter_findex.
rewrite rings_at /motion /= alphaK; split=> [/andP[_ /eqP Q]|->].
  by apply: (@walk_inj _ w); rewrite E; apply: (@iter_sigma_inj _ q); rewrite at_door.
by rewrite /looks /foretold /= (truth_matches I kh R) eqxx E at_door eqxx.
Qed.

Theorem door_runs q C c : reached_by seen_of rung 2 q C c ->
  (exists C' c', reached_by seen_of rung 2 m C' c' /\ nothing_open c') /\
  (nothing_open c -> [/\ q = m, C <= door_bound & robot_knows c]).
Proof.
by move=> R; split; [have := run_by_completes rung_iff R | have := run_by_correct rung_iff R].
Qed.

(* ---- The program there ---- *)
Local Notation makes := (makes door_percept).

Lemma asks_door k f (y : W) c d : bearing0 k = b -> f.1 = 0 ->
  degree y = degree_in (known_map k) f.1 -> due c d y -> exists c' z,
  makes (confirm door k f c) d (rung (known_map k) f y, c') z 2 /\ due c' z y.
Proof.
move=> kb f0 D du; rewrite /= /door_query kb /rung; set q := odflt 0 _.
exists (opposite (degree y) q), (iter q sigma y); split; last exact: opposite_turn.
apply: makes_go; rewrite (motion_due _ du); apply: makes_go; rewrite D.
by rewrite {2 3}/motion /= alphaK; exact: makes_return.
Qed.

Lemma seek_makes left k : k <= b -> b <= k + left ->
  makes (seek (degree v0) k left (door_percept (iter k sigma v0))) (iter k sigma v0)
    (knowledge_at_v0 (degree v0) b (opposite (degree v0) b)) (iter b sigma v0) (2 * (b - k)).
Proof.
have ring j : j <= b -> (iter j sigma v0 == pointed) = (j == b).
  move=> jb; apply/eqP/eqP=> [P|->]; last exact: iter_findex (@pointed_at_v0 W).
  rewrite /first_bearing -P findex_iter //; apply: leq_ltn_trans jb _.
  exact: findex_max (@pointed_at_v0 W).
elim: left k => [|left IH] k kb bk; rewrite /= rings_at ring //.
  have E : k = b by apply/eqP; rewrite eqn_leq kb; rewrite addn0 in bk.
  by rewrite E eqxx subnn; exact: makes_return.
case: eqP => [->|/eqP ne]; first by rewrite subnn; exact: makes_return.
have lt : k < b by rewrite ltn_neqAle ne.
have Y : motion 0 (motion 1 (iter k sigma v0)) = iter k.+1 sigma v0 by rewrite /motion /= alphaK.
rewrite -(subnSK lt) mulnS; apply: makes_go; apply: makes_go; rewrite Y.
by apply: IH => //; rewrite addSn -addnS.
Qed.

Lemma door_sets_out : exists k z,
  makes (set_out door (door_percept v0)) v0 k z (2 * b) /\ knows k (initial W) z.
Proof.
exists (knowledge_at_v0 (degree v0) b (opposite (degree v0) b)), (iter b sigma v0).
split; last first.
  split=> //; first exact: queue_initial.
  exact: opposite_turn.
rewrite -[b in 2 * b]subn0; apply: (@seek_makes (degree v0) 0) => //.
exact/ltnW/(findex_max (@pointed_at_v0 W)).
Qed.

Local Notation bound := (2 * b + door_bound).

Theorem door_correct pol budget : bound <= budget -> exists transcript answer z,
  [/\ episode (door_algorithm pol) (rooted v0) door_percept budget = (transcript, Some answer, z),
      size transcript <= bound, valid answer & isomorphic (denote answer) (rooted z)].
Proof.
exact: (@explorer_by_correct W _ _ door pol door_percept rung 2 door_seen (fun=> erefl) asks_door
  rung_iff (2 * b) door_sets_out budget).
Qed.

Lemma first_bearing_lt : b < degree v0.
Proof. exact: findex_max (@pointed_at_v0 W). Qed.
End InWorld.

(* ---- The bound, as sums ---- *)
Definition door_sum n m :=
  \sum_(1 <= s < n) (s + 2 * s * (2 * m - 2 * (s - 1))) +
  \sum_(1 <= i < (m - (n - 1)).+1) (n + 2 * n * (2 * m - 2 * (n - 1) - 2 * (i - 1))).

Lemma door_sum_paper n m : 0 < n -> n - 1 <= m -> paper_bound n m + 2 * m ^ 2 + 2 * m = door_sum n m.
Proof.
move=> n0 le; symmetry; rewrite -addnA.
rewrite -(_ : \sum_(0 <= p < m) 2 * (2 * m - 2 * p) = 2 * m ^ 2 + 2 * m); last first.
  elim: m {le} => [|m IH]; first by rewrite big_geq.
  rewrite big_nat_recl //= (eq_bigr (fun p => 2 * (2 * m - 2 * p))) => [|p _].
    by rewrite IH muln0 subn0 !expnS !expn0 !muln1 -!(plusE, multE, minusE); nia.
  by rewrite !mulnS subnDl.
have more s X : 0 < s -> s + 2 * s * X = s + 2 * (s - 1) * X + 2 * X.
  by case: s => // s _; rewrite -addnA subn1 /= mulnS mulnDl [2 * X + _]addnC.
rewrite [X in _ = _ + X](@big_cat_nat _ _ _ (n - 1)) //= /paper_bound /door_sum addnACA; congr (_ + _).
  rewrite /sum_1 !big_add1 !subn1 -big_split /=.
  by apply: eq_bigr => p _; rewrite more // subn1.
rewrite /sum_2 !big_add1 /= (_ : \sum_(n - 1 <= i < m) _ =
  \sum_(0 <= i < m - (n - 1)) 2 * (2 * m - 2 * (i + (n - 1)))).
  rewrite -big_split /=.
  by apply: eq_bigr => i _; rewrite more // [i.+1 - 1]subn1 /= -subnDA -mulnDr [i + _]addnC.
by rewrite -{1}[n - 1]add0n big_addn.
Qed.

Theorem door_bound_sum (W : lighthouse_world) :
  door_bound W + 2 * edges W = door_sum (vertices W) (edges W).
Proof.
apply: door_sum_paper; first exact: (vertices_gt0 (@start W)).
have [_ [C [c [R N _]]]] := run_ends (ReachedStart W).
have [v [l [K _]]] := (reached_counted _ _ _).1 R; have [_ E] := passes_of_each_kind K N.
by rewrite leq_subLR add1n -E leq_addl.
Qed.
