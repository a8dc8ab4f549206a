(* ---------------------------------------------------------------------------------------------
   A log with an open dart: it belongs to two worlds.                              Sections IV, V

     completed_world      the folded log, its open darts completed (Completion.v), with its marker.
     with_leaves, with_loops   the two completions of the folded log: by vertices of degree 1, and by
                          vertices of degree 3 with a loop.

     open_dart_two_worlds an open dart: two worlds agree with the log that have different numbers of
                          edges.
     no_open_dart_iff     and so, for a log with which some world agrees: no dart is open if and only
                          if the worlds that agree are the same.
     right_everywhere     the explorer is right in all worlds with a directional lighthouse.
     right_explorer_log_folds   then its log, in whatever world, leaves no dart open.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers.
From Allworlds Require Import Congruence Completion Log Folding.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Open.
Variables (L : log) (W : lighthouse_world).
Hypothesis A : agrees W L.
Local Notation N := (size (steps L)).
Local Notation log_dart := (log_dart L).
Local Notation dart_at := (dart_at L).
Local Notation next_dart := (@next_dart L).
Local Notation crossed := (@crossed L).
Local Notation sensed_pointed := (@sensed_pointed L).
Local Notation percept_at := (percept_at L).
Local Notation motion_at := (motion_at L).
Local Notation robot_at := (robot_at L).
Local Notation place := (@place L).
Local Notation same_dart := (@same_dart L).
Implicit Types p q : log_dart.
Local Notation folded_log := (folded next_dart crossed sensed_pointed).
Local Notation fold := (@fold log_dart next_dart crossed sensed_pointed).
Local Notation turns := (@folded_next log_dart next_dart crossed sensed_pointed).
Local Notation ends := (@folded_end log_dart next_dart crossed sensed_pointed).

Lemma turns_inj : injective turns.
Proof.
have Cg := (same_dart_congruence L).
move=> f g; rewrite -(fold_val f) -(fold_val g) !folded_nextE => /eqP; rewrite foldE => s.
have back : forall k x y, same_dart x y -> same_dart (iter k next_dart x) (iter k next_dart y).
  by elim=> //= k IH x y /IH; exact: (congruence_next Cg).
apply/eqP; rewrite foldE.
pose x := val f; pose y := val g; rewrite -/x -/y in s *.
have cyc z : exists2 k, 0 < k & iter k next_dart z = z.
  by exists (order next_dart z); [exact: order_gt0 | exact: (iter_order (@next_dart_inj L))].
have [k k0 Ek] := cyc x; have [l l0 El] := cyc y.
have mult n z j : iter n next_dart z = z -> iter (j * n) next_dart z = z.
  by move=> E; elim: j => // j IH; rewrite mulSn iterD IH.
have := back (k * l).-1 _ _ s; rewrite -!iterSr prednK ?muln_gt0 ?k0 //.
by rewrite (mult l y k) // mulnC (mult k x l).
Qed.

Lemma ends_sym f g : ends f = Some g -> ends g = Some f.
Proof.
move/eqP/folded_endP=> [x [y [E E' l]]]; apply/eqP/folded_endP; exists y, x; split=> //.
case/hasP: l => i li l; apply/hasP; exists i => //; by rewrite orbC.
Qed.

Lemma ends_neq f : ends f <> Some f.
Proof.
move/eqP/folded_endP=> [x [y [E E' l]]]; have := place_crossed A l.
have -> : place W y = place W x by apply: (folding_sound A); rewrite /same_dart -foldE E E'.
by move/esym/eqP; rewrite (negbTE (alpha_neq _)).
Qed.

Lemma folded_connected f g : connect (fun u v => (v == turns u) || (ends u == Some v)) f g.
Proof.
set e := fun u v => _; have sym x y : connect e x y -> connect e y x.
  case/connectP=> p + ->; elim: p x => //= z p IH x /andP[H /IH]; move/connect_trans; apply.
  case/orP: H => /eqP H; last by apply: connect1; rewrite /e (ends_sym H) eqxx orbT.
  have : fconnect turns z x by rewrite H (fconnect_sym turns_inj) fconnect1.
  by apply: connect_sub => a b /eqP <-; apply: connect1; rewrite /e eqxx.
have turn i j : i <= N -> connect e (fold (dart_at i 0)) (fold (dart_at i j)).
  move=> li; elim: j => // j IH; apply: connect_trans IH (connect1 _); apply/orP; left.
  by rewrite folded_nextE next_dart_at.
have start i : i <= N -> connect e (fold (dart_at 0 0)) (fold (dart_at i 0)).
  elim: i => // i IH li; apply: connect_trans (IH (ltnW li)) _.
  apply: connect_trans (turn i (motion_at i) (ltnW li)) (connect1 _); apply/orP; right.
  apply/folded_endP; exists (dart_at i (motion_at i)), (dart_at i.+1 0); split=> //.
  by apply/hasP; exists i; rewrite ?mem_iota // eqxx.
have all h : connect e (fold (dart_at 0 0)) h.
  rewrite -(fold_val h) (dart_atP (val h)); have li : tag (val h) <= N by rewrite -ltnS.
  exact: connect_trans (start _ li) (turn _ _ li).
exact: connect_trans (sym _ _ (all f)) (all g).
Qed.

Section Plug.
Variables (T : finType) (sT aT : T -> T) (stem : T).
Hypotheses (sT_inj : injective sT) (aTK : involutive aT).
Hypothesis aT_stem : forall t, (aT t == t) = (t == stem).
Hypothesis connT : forall t, connect (adjacent sT aT) stem t.

Definition completed_map :=
  completion turns_inj ends_sym ends_neq folded_connected sT_inj aTK aT_stem connT.
Definition old (p : log_dart) : completed_map := inl (fold p).

Lemma old_turn k p : iter k sigma (old p) = old (iter k next_dart p).
Proof. by rewrite /old -folded_iter; elim: k => //= k ->. Qed.

Lemma old_turn_at i k : i <= N -> iter k sigma (old (dart_at i 0)) = old (dart_at i k).
Proof. by move=> li; rewrite old_turn iter_next_dart // addn0. Qed.

Lemma old_crossed p q : crossed p q -> alpha (old p) = old q.
Proof.
move=> c; apply: (completed_alpha_glued (o := ends)); apply/eqP/folded_endP.
by exists p, q.
Qed.

Lemma oldE p q : (old p == old q) = same_dart p q.
Proof. by rewrite /same_dart -foldE. Qed.

Lemma old_pointed : at_same_vertex (old (dart_at 0 0)) (old (dart_at 0 (odflt 0 (percept_at 0).2))).
Proof.
have <- := old_turn_at (odflt 0 (percept_at 0).2) (leq0n N); exact: fconnect_iter.
Qed.

Definition completed_world := LighthouseWorld old_pointed.

Lemma old_robot i : i <= N -> walk (take i (motions L)) (@start completed_world) =
  old (dart_at i 0).
Proof.
elim: i => [|i IH] li; first by rewrite take0.
have := @robot_atS L completed_world i li; rewrite /robot_at => ->; rewrite IH ?(ltnW li) //.
rewrite /motion old_turn_at ?(ltnW li) //; apply: old_crossed.
by apply/hasP; exists i; rewrite ?mem_iota // eqxx.
Qed.

Lemma completed_agrees : agrees completed_world L.
Proof.
have nthP (V : lighthouse_world) w (d : V) o j : j <= size w ->
    nth o (percepts_along w d) j = percept_of (walk (take j w) d).
  by elim: w d j => [|k w IH] d [|j] //= lj; exact: IH.
apply: (@eq_from_nth _ (first_percept L)); first by rewrite size_percepts /= !size_map.
move=> i; rewrite size_percepts size_map ltnS => li; rewrite nthP ?size_map // old_robot //.
rewrite -/(percept_at i) (percept_atE A) //; apply: percept_transfer => j.
  rewrite old_turn_at // oldE; apply/idP/eqP=> [/(folding_sound A)|E]; first by rewrite !place_at.
  rewrite (@dart_at_eq L i j 0) ?(congruence_refl (same_dart_congruence L)) // (darts_atE A) // mod0n.
  have lt := ltn_pmod j (degree_gt0 (robot_at W i)).
  by rewrite -(findex_iter lt) turn_modulo_degree E findex0.
rewrite old_turn_at // oldE; apply/idP/eqP=> [/(folding_sound A)|E].
  by rewrite (place_pointed A (sensed_pointed_first A)) place_at.
apply: (congruence_mark (same_dart_congruence L)); last exact: (sensed_pointed_first A).
apply/hasP; exists i; first by rewrite mem_iota.
have c : at_same_vertex (robot_at W i) pointed by rewrite -E; exact: fconnect_iter.
rewrite (percept_atE A) // /percept_of /bearing /= c; apply/eqP/dart_at_eq => //.
rewrite (darts_atE A) // -[X in findex _ _ X]E -turn_modulo_degree findex_iter ?modn_mod //.
exact: ltn_pmod (degree_gt0 _).
Qed.

Lemma card_completed_world : #|completed_world| = #|folded_log| + #|loose ends| * #|T|.
Proof. exact: card_completion. Qed.
End Plug.
End Open.

(* the two ways in which every open dart is completed: by a vertex of degree 1; by a vertex of
   degree 3 with a loop *)
Lemma leaf_end (t : unit) : (id t == t) = (t == tt).
Proof. by case: t. Qed.

Lemma leaf_connected (t : unit) : connect (adjacent id id) tt t.
Proof. by case: t; exact: connect0. Qed.

Definition loop_sigma (t : option bool) : option bool :=
  match t with None => Some true | Some true => Some false | Some false => None end.
Definition loop_alpha : option bool -> option bool := omap negb.

Lemma loop_sigma_inj : injective loop_sigma.
Proof. by move=> [[]|] [[]|]. Qed.

Lemma loop_alphaK : involutive loop_alpha.
Proof. by move=> [[]|]. Qed.

Lemma loop_end t : (loop_alpha t == t) = (t == None).
Proof. by case: t => [[]|]. Qed.

Lemma loop_connected t : connect (adjacent loop_sigma loop_alpha) None t.
Proof.
case: t => [[]|]; last exact: connect0; first exact: connect1.
by apply: (@connect_trans _ _ (Some true)); exact: connect1.
Qed.

Section TwoWorlds.
Variables (L : log) (W : lighthouse_world).
Hypothesis A : agrees W L.

Definition with_leaves : lighthouse_world :=
  completed_world A (@inj_id unit) (fun t => erefl) leaf_end leaf_connected.

Definition with_loops : lighthouse_world :=
  completed_world A loop_sigma_inj loop_alphaK loop_end loop_connected.

Theorem open_dart_two_worlds (p : log_dart L) : ~~ dart_settled p ->
  [/\ agrees with_leaves L, agrees with_loops L & edges with_leaves <> edges with_loops].
Proof.
move=> np; split; try exact: completed_agrees.
move/(congr1 double); rewrite !edges_double !card_completed_world card_unit card_option card_bool.
move/addnI/eqP; rewrite eqn_mul2l; case/orP=> // /eqP E.
have G : folded_end (fold (@next_dart L) (@crossed L) (@sensed_pointed L) p) == None.
  by rewrite folded_end_none.
suff: 0 < #|loose (@folded_end _ (@next_dart L) (@crossed L) (@sensed_pointed L))| by rewrite E.
by apply/card_gt0P; exists (as_loose G).
Qed.
End TwoWorlds.

Corollary no_open_dart_iff L W : agrees W L ->
  no_open_dart L <->
  (forall W1 W2, agrees W1 L -> agrees W2 L ->
    isomorphic (rooted (@start W1)) (rooted (@start W2))).
Proof.
move=> A; split=> [nopen W1 W2 A1 A2|H p].
  have := folding_isomorphic A1 A2 nopen (leq0n _); by rewrite /robot_at !take0.
have [//|np] := boolP (dart_settled p); have [A1 A2 []] := open_dart_two_worlds A np.
have [f [g [F G _]]] := H _ _ A1 A2.
apply: double_inj; rewrite !edges_double; apply: (@bij_eq_card _ _ f).
by exists g => x; [have [] := F x isT | have [] := G x isT].
Qed.

(* ---- The log of an explorer ---- *)
Definition right_everywhere E (meaning : E -> rooted_map) (X : explorer percept E) :=
  forall W : lighthouse_world, right meaning X (rooted (@start W)) (@percept_of W).

Section RightExplorer.
Variables (E : Type) (meaning : E -> rooted_map) (X : explorer percept E).

(* an explorer that is right in two worlds that agree with its log: they are the same rooted map *)
Theorem right_explorer_determines (W W' : lighthouse_world) fuel t e z :
  right meaning X (rooted (@start W)) (@percept_of W) ->
  right meaning X (rooted (@start W')) (@percept_of W') ->
  episode X (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) ->
  agrees W' (log_of W t) -> isomorphic (rooted (@start W)) (rooted (@start W')).
Proof.
move=> [f1 [t1 [e1 [z1 [R1 We1 I1]]]]] [f2 [t2 [e2 [z2 [R2 We2 I2]]]]] R A'.
have zE := (explore_log R).2.
have P : percept_of (@start W') = percept_of (@start W) 
  by have := congr1 (head (0, None)) A'; case: (t).
have R' : episode X (rooted (@start W')) (@percept_of W') fuel =
  (t, Some e, walk (unzip1 t) (@start W')).
  have R0 : explore X (rooted (@start W)) (@percept_of W) fuel [:: percept_of (@start W)] (@start W)
    = (t, Some e, z) by [].
  by have := explore_replay R0 (etrans A' (f_equal (cons^~ _) (esym P))); rewrite -P.
have := explore_more fuel R1; rewrite addnC (explore_more f1 R) => -[_ ee zz]; subst e1 z1.
have := explore_more fuel R2; rewrite addnC (explore_more f2 R') => -[_ ee zz]; subst e2 z2.
have I := isomorphic_trans (isomorphic_sym We1 I1) I2; rewrite zE in I.
have walkE (V : lighthouse_world) v (d : V) : walk_in (rooted (@start V)) v d =
  walk v d by elim: v d => /=.
apply: (@isomorphic_back (rooted (@start W)) (rooted (@start W')) (unzip1 t) start start) => //.
- exact: rooted_wellformed.
- exact: rooted_wellformed.
by rewrite !walkE.
Qed.

Theorem right_explorer_log_folds : right_everywhere meaning X ->
  forall W fuel t e z,
  episode X (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) -> no_open_dart (log_of W t).
Proof.
move=> H W fuel t e z R; have A := episode_agrees R; apply/(no_open_dart_iff A) => W1 W2 A1 A2.
apply: isomorphic_trans (right_explorer_determines (H W) (H W2) R A2).
apply: isomorphic_sym; first exact: rooted_wellformed.
exact: right_explorer_determines (H W) (H W1) R A1.
Qed.
End RightExplorer.
