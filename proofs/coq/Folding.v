(* ---------------------------------------------------------------------------------------------
   Folding: the log of a robot with a directional lighthouse is a proof of the map.Sections IV, V

     folding_determines   no open dart: any two worlds that agree with the log are the same, by a
                          bijection that keeps the marker and the whole way of the robot.
     folding_isomorphic   so they are the same rooted map, from wherever the robot was.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Congruence Log.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Folding.
Variable L : log.
Local Notation N := (size (steps L)).
Local Notation log_dart := (log_dart L).
Local Notation dart_at := (dart_at L).
Local Notation no_open_dart := (no_open_dart L).
Local Notation robot_at := (robot_at L).
Local Notation place := (@place L).
Implicit Types p q : log_dart.

Lemma percept_place W W' (A : agrees W L) (A' : agrees W' L) p :
  percept_of (place W' p) = percept_of (place W p).
Proof.
have li : tag p <= N by rewrite -ltnS.
rewrite (dart_atP p) !place_at //; move: (val (tagged p)) => j.
have := percept_atE A' li; rewrite (percept_atE A li) => -[D B].
have T (V : lighthouse_world) (x : V) : 
  percept_of (iter j sigma x) = (degree x, omap (fun b =>
    (b + (degree x - j %% degree x)) %% degree x) (bearing x)).
  have c : at_same_vertex x (iter j sigma x) by exact: fconnect_iter.
  rewrite /percept_of /bearing (degree_same c); congr (_, _).
  have -> : at_same_vertex (iter j sigma x) pointed = at_same_vertex x (@pointed V).
    by rewrite /at_same_vertex (same_connect (fconnect_sym sigma_inj) c).
  case: ifP => // cx; congr Some.
  have E : iter ((findex sigma x pointed + (degree x - j %% degree x)) %% degree x) sigma
    (iter j sigma x) = pointed.
    have -> : iter j sigma x = iter (j %% degree x) sigma x by rewrite turn_modulo_degree.
    have dx : degree (iter (j %% degree x) sigma x) = degree x by apply: degree_same;
      exact: fconnect_iter.
    rewrite -{3}dx turn_modulo_degree -iterD -addnA subnK ?(ltnW (ltn_pmod _ (degree_gt0 _))) //.
    by rewrite iterD iter_degree iter_findex.
  by rewrite -[X in findex _ _ X]E findex_iter // -/(degree _) (degree_same c) ltn_pmod ?degree_gt0.
by rewrite !T -D -B.
Qed.

Theorem folding_determines W W' : agrees W L -> agrees W' L -> no_open_dart ->
  exists f : W -> W', [/\ bijective f, forall x, f (sigma x) = sigma (f x),
    forall x, f (alpha x) = alpha (f x), f pointed = pointed &
    forall i, i <= N -> f (robot_at W i) = robot_at W' i].
Proof.
have key (V V' : lighthouse_world) : agrees V L -> agrees V' L -> no_open_dart ->
    forall p q, place V p = place V q -> place V' p = place V' q.
  move=> A A' nopen p q E.
  have bis w (r t : log_dart) : place V r = place V t ->
      exists r' t', [/\ place V r' = walk w (place V r), place V t' = walk w (place V t), 
        place V' r' = walk w (place V' r) & place V' t' = walk w (place V' t)].
    elim: w r t => [|k w IH] r t E'; first by exists r, t.
    have step (u : log_dart) : exists u', place V u' = motion k (place V u) /\ place V' u' =
      motion k (place V' u).
      have tn : exists v, place V v = iter k sigma (place V u) /\ place V' v =
        iter k sigma (place V' u).
        elim: k => [|k [v [e e']]]; first by exists u.
        by exists (next_dart v); rewrite !place_next // e e'.
      have [v [e e']] := tn; have /existsP[u' o] := nopen v; exists u'.
      by rewrite (folding_sound_ends A o) (folding_sound_ends A' o) e e'.
    have [r' [e1 e2]] := step r; have [t' [e3 e4]] := step t.
    have [|r'' [t'' [f1 f2 f3 f4]]] := IH r' t'; first by rewrite e1 e3 E'.
    by exists r'', t''; rewrite f1 f2 f3 f4 e1 e2 e3 e4.
  (* some motions lead from place V p to a dart at v0 *)
  have [w [b B]] : exists w b, bearing (walk w (place V p)) = Some b.
    have: exists w k, walk w (place V p) = iter k sigma start.
      pose R (x : V) := exists w k, walk w (place V p) = iter k sigma x.
      suff H : forall x, R x by exact: H.
      have Rs x : R x -> R (sigma x).
        case=> w [k e]; exists w, (opposite (degree x) 1 + k); rewrite e addnC iterD;
          congr (iter _ _ _).
        by rewrite -[in LHS](opposite_turn 1 x).
      apply: (@everywhere V R (place V p)) => [||x [w [k e]]] //; first by exists [::], 0.
      exists (rcons w (opposite (degree x) k)), 0.
      have -> v d j : walk (rcons v j) d = motion j (walk v d) by elim: v d => //= a v IHv d.
      rewrite e /motion /=; congr alpha; have := opposite_turn k x.
      by [].
    case=> w [k e]; exists w; rewrite e; have c : at_same_vertex (iter k sigma start) (@pointed V).
      rewrite /at_same_vertex -(same_connect (fconnect_sym sigma_inj) (fconnect_iter _ k _)).
      exact: pointed_at_v0.
    by rewrite /bearing c; eexists.
  have [p' [q' [e1 e2 e3 e4]]] := bis w p q E.
  apply: (@walk_inj _ w); rewrite -e3 -e4.
  have P1 := percept_place A A' p'; have P2 := percept_place A A' q'.
  rewrite e1 in P1; rewrite e2 -E in P2; case: P1 => _ B1; case: P2 => _ B2.
  by apply: (@bearing_inj V' _ _ b); rewrite ?B1 ?B2.
move=> A A' nopen.
pose pre (V : lighthouse_world) (x : V) := odflt (dart_at 0 0) [pick p | place V p == x].
have preP V (AV : agrees V L) x : place V (pre V x) = x.
  rewrite /pre; case: pickP => [p /eqP //|H]; have [p e] := place_onto AV nopen x.
  by have := H p; rewrite e eqxx.
pose f (x : W) := place W' (pre W x); pose g (y : W') := place W (pre W' y).
have fP p : f (place W p) = place W' p by apply: (key W W') => //; exact: preP.
have gP p : g (place W' p) = place W p by apply: (key W' W) => //; exact: preP.
exists f; split.
- by exists g => [x|y]; [rewrite [f x]/(place W' _) gP preP | rewrite [g y]/(place W _) fP preP].
- by move=> x; rewrite -{1}(preP W A x) -place_next // fP place_next.
- move=> x; rewrite -{1}(preP W A x); have /existsP[q o] := nopen (pre W x).
  by rewrite -(folding_sound_ends A o) fP (folding_sound_ends A' o).
- have m := sensed_pointed_first A; by rewrite -(place_pointed A m) fP (place_pointed A' m).
by move=> i li; rewrite -[robot_at W i](place_at A 0 li) fP place_at.
Qed.

Corollary folding_isomorphic W W' : agrees W L -> agrees W' L -> no_open_dart ->
  forall i, i <= N -> isomorphic (rooted (@robot_at W i)) (rooted (@robot_at W' i)).
Proof.
move=> A A' nopen i li; have [f [[g fK gK] fs fa _ fr]] := folding_determines A A' nopen.
exists f, g; split=> [x _|y _|] /=; [by split | by split | exact: fr].
Qed.

End Folding.
