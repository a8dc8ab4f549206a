(* ---------------------------------------------------------------------------------------------
   The program is an instance of the relation, and right.                   Sections IV, V and VI

   For any lighthouse L, once it is known in what its percepts and `confirm` amount to in the world:
     explorer_by_correct  if each test decides its hypothesis and set_out finds the bearing, the
                          explorer is right, within any budget that covers set_out and bound_by.
     resumed_correct      the same from where the first knowledge is there.
     estimate_right       when U is empty the estimate is the world seen from the robot's true
                          dart.

   For the directional lighthouse:
     one_pass_is_pass     each pass of the program is a `pass`, with the same traversals.
     algorithm1_correct   in every world with a directional lighthouse, under every policy, with
                          any budget of at least (1)+(2) traversals: it stops after at most
                          (1)+(2), and is right.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Codes Explorers Indistinguishable.
From Allworlds Require Import PartialMaps HypothesisTests Pass Cost Correctness Lighthouses Algorithm.
From Allworlds Require Import Queue Execution OnePass.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section InWorld.
Variables (W : lighthouse_world) (O : Type) (B : eqType) (L : lighthouse O B) (pol : policy).
Variable senses : W -> O.
Local Notation v0 := (@start W).
Local Notation b := (first_bearing W).
Local Notation phi := (@phi W v0).
Local Notation program := (program O).
Local Notation makes := (makes senses).
Local Notation foretells := (foretells L).

Variables (confirms : partial_map -> dart -> W -> bool) (confirm_cost : nat).
Hypothesis reads_senses : forall d, reads L (senses d) = foretells (percept_of d).
Hypothesis degree_foretold : forall o, (foretells o).1 = o.1.
Hypothesis confirm_makes : forall k f y c d, bearing0 k = b -> f.1 = 0 ->
  degree y = degree_in (known_map k) f.1 -> due c d y -> exists c' z,
  makes (confirm L k f c) d (confirms (known_map k) f y, c') z confirm_cost /\ due c' z y.

Local Notation looks := (looks foretells).
Local Notation matches := (matches foretells confirms).
Local Notation failed_cost := (failed_cost foretells confirm_cost).
Local Notation refuted := (refuted foretells confirms).
Local Notation pass_by := (pass_by foretells confirms confirm_cost).

(* ---- The whole run ---- *)
Local Notation machine := (machine L pol motion senses).

Hypothesis decides : forall S r h w f x, embedded v0 S r -> known S h -> follow S w h = Some f ->
  f.1 = 0 -> matches S x (h, w) f <-> x = phi r h.
Local Notation reached_by := (reached_by foretells confirms confirm_cost).

Lemma program_run k c d n C : reached_by n C c -> knows k c d ->
  exists t k' c' d' n', [/\ machine (size t) (Return k) d = (t, Some (estimate k'), d'),
    reached_by n' (C + size t) c', knows k' c' d' & unexplored k' = [::]].
Proof.
have [N] := ubnP (edges W - n); elim: N k c d n C => // N IH k c d n C lN R K.
case: (boolP (unexplored k == [::])) => [/eqP U|U].
  by exists [::], k, c, d, n; rewrite addn0; split=> //=; rewrite U.
have [C0 R0] := reached_by_reached decides R.
have [k1 [z [n1 [c1 [[t1 [E1 s1]] P1 K1]]]]] :=
  one_pass_makes pol reads_senses degree_foretold confirm_makes (reached_sound R0) K U.
have R1 := ReachedByPass R P1; have [|t [k' [c' [d' [n' [A D F G]]]]]] := IH _ _ _ _ _ _ R1 K1.
  have [C1 R'] := reached_by_reached decides R1.
  by rewrite ltnS in lN; apply: leq_trans lN; apply: ltn_sub2l => //; exact: (run_passes R').
exists (t1 ++ t), k', c', d', n'; split=> //; last by rewrite size_cat addnA s1.
by rewrite size_cat (machine_next _ _ _ (next_pass _ _ U)); exact: (machine_exec E1 A).
Qed.

(* ---- The estimate is the world, seen from where the robot is ---- *)
Lemma estimate_denotes S h t : known S h -> (forall e, ~~ is_open S e) ->
  (forall e f, partner S e = Some f -> known S f) ->
  let answer := NumberedMap [seq number_of S (turn S 1 e) | e <- darts S]
      [seq number_of S (odflt e (partner S e)) | e <- darts S] (number_of S (turn S t h)) in
  isomorphic (denote answer) (map_with_robot S (turn S t h)).
Proof.
move=> kh nopen Hl answer; pose f i := nth (0, 0) (darts S) i.
have nK e : known S e -> number_of S e < size (darts S) /\ f (number_of S e) = e.
  by move=> ke; rewrite /number_of index_mem mem_darts ke /f nth_index // mem_darts.
have kf i : i < size (darts S) -> known S (f i) by move=> li; rewrite -mem_darts mem_nth.
have kp e : known S e -> known S (odflt e (partner S e)).
  by case E: (partner S e) => [g|] //= _; exact: Hl E.
exists f, (number_of S); split.
- move=> i; rewrite /= size_map => li; split.
  + exact: kf.
  + by rewrite /number_of index_uniq ?darts_uniq.
  + by rewrite /= (nth_map (0, 0)) //; have [_ ->] := nK _ (known_turn 1 (kf i li)).
  + by rewrite /= (nth_map (0, 0)) //; have [_ ->] := nK _ (kp _ (kf i li)).
- by move=> e ke; rewrite /= size_map; exact: nK.
by have [_ ->] := nK _ (known_turn t kh).
Qed.

Lemma estimate_right k (c : configuration W) d : sound c -> knows k c d -> unexplored k = [::] ->
  [/\ nothing_open c, valid (estimate k) & isomorphic (denote (estimate k)) (rooted d)].
Proof.
case=> r [I kh ph _] [_ ES Eh [_ mU] du] U; rewrite ES Eh in I kh ph.
set S := known_map k in I kh *; set h := at_dart k in kh ph.
have nopen e : ~~ is_open S e by rewrite -mU U.
have X := complete_when_nothing_open I nopen.
set t := opposite (degree_in S h.1) (due_turn k).
have kt : known S (turn S t h) by exact: known_turn.
have Hd : phi r (turn S t h) = d.
  have [l1 _] := knownP I kh; rewrite (phi_turn I) // -ph -du /t (degree_phi I l1).
  rewrite -(degree_same (phi_vertex v0 r h)) -ph -du.
  by rewrite (degree_same (fconnect_iter sigma _ d)) opposite_turn.
have J := isomorphic_trans (estimate_denotes t kh nopen (partner_known I)) (complete_isomorphic I X kt).
rewrite Hd in J; split=> //; first by rewrite /nothing_open ES.
have nK e : known S e -> number_of S e < size (darts S) by rewrite /number_of index_mem mem_darts.
have nP g : (forall e, known S e -> known S (g e)) -> forall i, i < size (darts S) ->
    nth 0 [seq number_of S (g e) | e <- darts S] i < size (darts S).
  move=> kg i li; rewrite (nth_map (0, 0)) //; apply/nK/kg.
  by rewrite -mem_darts mem_nth.
apply: validI; last by rewrite /= !size_map.
apply: (isomorphic_wellformed J (rooted_wellformed d)) => /=; rewrite ?size_map.
- exact: nK.
- by move=> i; apply: nP => e; exact: known_turn.
move=> i; apply: nP => e ke; case E: (partner S e) => [g|] //=; exact: (partner_known I E).
Qed.

(* once the first knowledge is there *)
Theorem resumed_correct k0 z0 : knows k0 (initial W) z0 -> exists t answer z,
  [/\ machine (size t) (Return k0) z0 = (t, Some answer, z), size t <= bound_by W confirm_cost,
      valid answer & isomorphic (denote answer) (rooted z)].
Proof.
move=> K0; have [t [k [c [d [n [A R K U]]]]]] := program_run (ReachedByStart _ _ _) K0.
have [C0 R0] := reached_by_reached decides R.
have [nopen V J] := estimate_right (reached_sound R0) K U.
have [_ Cb _] := run_by_correct decides R nopen; rewrite add0n in Cb.
by exists t, (estimate k), d.
Qed.

(* with any budget that is large enough *)
Variable set_out_cost : nat.
Hypothesis set_out_makes : exists k z,
  makes (set_out L (senses v0)) v0 k z set_out_cost /\ knows k (initial W) z.
Local Notation bound := (set_out_cost + bound_by W confirm_cost).

Theorem explorer_by_correct budget : bound <= budget -> exists transcript answer z,
  [/\ episode (explorer_by L pol) (rooted v0) senses budget = (transcript, Some answer, z),
      size transcript <= bound, valid answer & isomorphic (denote answer) (rooted z)].
Proof.
move=> le; have [k0 [z0 [[t0 [E0 s0]] K0]]] := set_out_makes.
have [t [answer [z [A Cb V J]]]] := resumed_correct K0.
have Cb' : size (t0 ++ t) <= bound by rewrite size_cat s0 leq_add2l.
exists (t0 ++ t), answer, z; split=> //; rewrite -(subnKC (leq_trans Cb' le)).
apply: explore_more; rewrite explore_machine size_cat; exact: (machine_exec E0 A).
Qed.
End InWorld.

(* ---- Algorithm 1, with a directional lighthouse ---- *)
Section Directional.
Variables (W : lighthouse_world) (pol : policy).
Local Notation v0 := (@start W).
Local Notation always := (fun _ _ (_ : W) => true).
Local Notation senses := (@percept_of W).

Lemma nothing_to_confirm k f (y : W) c d : due c d y -> exists c' z,
  makes senses (confirm directional k f c) d (true, c') z 0 /\ due c' z y.
Proof. by exists c, d; split=> //; exact: makes_return. Qed.

Lemma directional_decides S r h w f (x : W) : embedded v0 S r -> known S h ->
  follow S w h = Some f -> f.1 = 0 ->
  matches (foretells directional) always S x (h, w) f <-> x = phi v0 r h.
Proof.
by move=> I kh R f0; rewrite directional_matches -(test_iff I x kh R f0); split=> /eqP.
Qed.

Theorem one_pass_is_pass k c d : sound c -> knows k c d -> unexplored k != [::] ->
  exists k' z n c', [/\ makes senses (one_pass directional pol k) d k' z n,
    pass (next_edge pol k) c n c' & knows k' c' z].
Proof.
move=> Ok K U.
have [//|//|k0 f y c0 d0 _ _ _|k' [z [n [c' [A P K']]]]] :=
  @one_pass_makes W _ _ directional pol senses always 0 _ _ _ k c d Ok K U.
  exact: nothing_to_confirm.
by exists k', z, n, c'; split=> //; exact: directional_pass.
Qed.

Theorem algorithm1_correct budget : paper_bound (vertices W) (edges W) <= budget ->
  exists transcript answer z,
  [/\ episode (algorithm1 pol) (rooted v0) (@percept_of W) budget = (transcript, Some answer, z),
      size transcript <= paper_bound (vertices W) (edges W),
      valid answer & isomorphic (denote answer) (rooted z)].
Proof.
have <- : 0 + bound_by W 0 = paper_bound (vertices W) (edges W).
  by rewrite /bound_by mul0n addn0.
apply: (@explorer_by_correct W _ _ directional pol senses always) => //.
- by move=> k f y c d _ _ _; exact: nothing_to_confirm.
- exact: directional_decides.
exists (first_knowledge (percept_of v0)), v0; split; first exact: makes_return.
by split=> //; [rewrite /= bearing_start | exact: queue_initial].
Qed.

Corollary algorithm1_right : right denote (algorithm1 pol) (rooted v0) (@percept_of W).
Proof.
have [t [e [z [A _ V J]]]] := algorithm1_correct (leqnn _).
by exists (paper_bound (vertices W) (edges W)), t, e, z; split=> //; exact: validP.
Qed.
End Directional.

(* worlds with a directional lighthouse that no motion tells apart are the same rooted map *)
Corollary directional_unambiguous (W1 W2 : lighthouse_world) (R : W1 -> W2 -> Prop) :
  (forall x y, R x y -> percept_of x = percept_of y) ->
  (forall x y, R x y -> R (sigma x) (sigma y)) -> (forall x y, R x y -> R (alpha x) (alpha y)) ->
  R start start -> isomorphic (rooted (@start W1)) (rooted (@start W2)).
Proof.
move=> Ro Rs Ra R0.
pose oldest := Policy (fun _ => (0, 0)) (fun _ _ => [::]) (fun _ _ hs => hs) (fun _ _ => [::]).
apply: (@twins_impossible _ _ denote (algorithm1 oldest) (rooted start) (rooted start)
  (@percept_of W1) (@percept_of W2) R) => //; try exact: rooted_wellformed.
- exact: algorithm1_right.
- exact: algorithm1_right.
Qed.
