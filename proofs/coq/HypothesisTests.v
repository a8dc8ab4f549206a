(* ---------------------------------------------------------------------------------------------
   Hypothesis tests.                                             Section IV, cases (1)-(3); Section V

   The robot has come in by an unknown dart x of the world and asks whether x is the open dart h
   of S. It makes the motions w of a path from h to v0 in S (follow S w h = Some f, and f lies at
   vertex 0) and compares what it senses with expected_percepts S w h.

     match_proves       percepts that match throughout prove the hypothesis (case 3): x is phi h.
     truth_matches      a true hypothesis matches throughout, so a mismatch refutes (cases 1 and
                        2).
     test_iff           both: a test matches if and only if its hypothesis is true.
     embedded_path_unique   the uniqueness of the embedded path: the motions to v0 and the
                        percepts expected on the way determine the dart that they start from.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts PartialMaps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section HypothesisTests.
Variable W : lighthouse_world.
Local Notation v0 := (@start W).
Local Notation embedded := (@embedded W v0).
Local Notation phi := (@phi W v0).
Local Notation b := (first_bearing W).

Section Embedded.
Variables (S : partial_map) (r : seq W).
Hypothesis I : embedded S r.

(* S foretells what is sensed *)
Lemma expected_percept_phi e : known S e -> expected_percept b S e = percept_of (phi r e).
Proof.
move=> ke; have [l1 l2] := knownP I ke; rewrite /expected_percept /percept_of (degree_phi I) //.
rewrite (degree_same (phi_vertex v0 r e)); congr (_, _).
have [r0 n0] := embedded_start I; case: eqP => [e0|ne0]; last first.
  rewrite /bearing; case: ifP => // c; case: ne0; apply: (embedded_apart I) => //; rewrite n0.
  apply: connect_trans (phi_vertex v0 r e) (connect_trans c _).
  by rewrite -/(at_same_vertex _ _) at_same_vertex_sym; exact: pointed_at_v0.
rewrite (degree_phi I) // n0; rewrite e0 n0 in l2; rewrite /phi e0 n0.
set i := e.2 in l2 *; set o := degree v0 in l2 *.
have c : at_same_vertex v0 (iter i sigma v0) by exact: fconnect_iter.
have oi : degree (iter i sigma v0) = o by rewrite (degree_same c).
have E : iter ((b + (o - i)) %% o) sigma (iter i sigma v0) = pointed.
  rewrite -{2}oi turn_modulo_degree -iterD -addnA subnK ?(ltnW l2) // iterD iter_degree.
  exact: (iter_findex (@pointed_at_v0 W)).
rewrite /bearing; have -> : at_same_vertex (iter i sigma v0) pointed by rewrite -E;
  exact: fconnect_iter.
congr Some; by rewrite -[X in findex _ _ X]E findex_iter // -/(degree _) oi ltn_mod (leq_ltn_trans
  _ l2).
Qed.

Lemma expected_percepts_phi w e f : known S e -> follow S w e = Some f ->
  expected_percepts b S w e = percepts_along w (phi r e).
Proof.
elim: w e => [|k w IH] e ke /=; first by rewrite expected_percept_phi.
case L: (partner S (turn S k e)) => [g|] // R; rewrite expected_percept_phi //.
have [_ kg ag _] := embedded_links I (partnerP L).
by rewrite (IH g) // /motion -(phi_turn I) // ag.
Qed.

Lemma match_proves w h f x : known S h -> follow S w h = Some f -> f.1 = 0 ->
  percepts_along w x = expected_percepts b S w h -> x = phi r h.
Proof.
move=> kh R f0 T; have [kf E] := follow_phi I kh R.
have: last (percept_of x) (percepts_along w x) = last (percept_of x) (percepts_along w (phi r h)).
  by rewrite T (expected_percepts_phi kh R).
rewrite !percepts_last E -(expected_percept_phi kf) /expected_percept f0 /= /percept_of => -[_ B].
apply: (@walk_inj _ w); rewrite E; apply: (bearing_inj B).
by have := expected_percept_phi kf; rewrite /expected_percept /percept_of f0 /= => -[_ <-].
Qed.

Lemma truth_matches w h f : known S h -> follow S w h = Some f ->
  percepts_along w (phi r h) = expected_percepts b S w h.
Proof. by move=> kh R; rewrite (expected_percepts_phi kh R). Qed.

Theorem test_iff w h f x : known S h -> follow S w h = Some f -> f.1 = 0 ->
  percepts_along w x = expected_percepts b S w h <-> x = phi r h.
Proof.
move=> kh R f0; split=> [|->]; first exact: match_proves kh R f0.
exact: truth_matches kh R.
Qed.

Theorem embedded_path_unique w h1 f1 h2 f2 : known S h1 -> known S h2 ->
  follow S w h1 = Some f1 -> f1.1 = 0 -> follow S w h2 = Some f2 ->
  expected_percepts b S w h1 = expected_percepts b S w h2 -> h1 = h2.
Proof.
move=> k1 k2 R1 f0 R2 E; apply: (phi_inj I k1 k2); symmetry; apply: (match_proves k1 R1 f0).
by rewrite E; exact: truth_matches k2 R2.
Qed.
End Embedded.

Lemma size_expected S w h f : follow S w h = Some f -> size (expected_percepts b S w h) = (size w).+1.
Proof. by elim: w h => //= k w IH h; case: (partner S _) => //= g /IH ->. Qed.
End HypothesisTests.
