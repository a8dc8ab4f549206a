(* ---------------------------------------------------------------------------------------------
   A log with an open dart: it belongs to two worlds.                              Sections IV, V

     completed_world      the folded log, its open darts completed (Completion.v), with its marker.
     with_leaves, with_paths   the two completions of the folded log: an edge, or two edges in a row,
                          behind each open dart.  In a simple world both are simple.

     open_dart_two_worlds an open dart: two worlds agree with the log that have different numbers of
                          edges.
     no_open_dart_iff     and so, for a log with which some world agrees: no dart is open if and only
                          if the worlds that agree are the same.
     one_log_one_map      an explorer that finds the maps of two worlds that agree with its log: they are
                          the same map.
     explorer_log_folds   an explorer that finds all maps (of all worlds, or of all simple worlds): its
                          log leaves no dart open.
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

(* ---- Where the darts of the folded log are in the world ---- *)
Definition place_of (f : folded_log) := place W (val f).

Lemma place_of_fold p : place_of (fold p) = place W p.
Proof. by apply/esym/(folding_sound A); rewrite /same_dart -foldE fold_val. Qed.

Lemma place_of_turn f : place_of (turns f) = sigma (place_of f).
Proof. by rewrite place_of_fold (place_next A). Qed.

Lemma place_of_vertex f g : fconnect turns f g -> at_same_vertex (place_of f) (place_of g).
Proof.
move/iter_findex <-; elim: (findex _ _ _) => [|k IH] /=; first exact: connect0.
by rewrite place_of_turn; apply: connect_trans IH _; exact: fconnect1.
Qed.

Lemma place_of_end f g : ends f = Some g -> place_of g = alpha (place_of f).
Proof.
by move/eqP/folded_endP=> [p [q [<- <- c]]]; rewrite !place_of_fold; exact: (place_crossed A).
Qed.

(* a vertex of the log has as many darts as the vertex of the world *)
Lemma place_of_inj f g : fconnect turns f g -> place_of f = place_of g -> f = g.
Proof.
move/iter_findex <-; move: (findex _ _ _) => k; rewrite -[f]fold_val folded_iter !place_of_fold.
move: (val f) => p E; congr fold; have li : tag p <= N by rewrite -ltnS.
move: E; rewrite (dart_atP p) iter_next_dart // !(place_at A) //; move: (val _) => j E.
apply: dart_at_eq => //; rewrite (darts_atE A) //; set x := robot_at W _ in E *.
have lt i : i %% degree x < degree x by rewrite ltn_mod degree_gt0.
by rewrite -(findex_iter (lt (k + j))) -(findex_iter (lt j)) !turn_modulo_degree E.
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

(* a completion by a simple piece stays simple *)
Hypothesis simple_piece : forall t t', fconnect sT t t' -> fconnect sT (aT t) (aT t') -> t = t'.

Lemma same_vertex_completed (x y : completed_map) : at_same_vertex x y ->
  match x, y return Prop with
  | inl f, inl g => fconnect turns f g
  | inr (l, t), inr (l', t') => l = l' /\ fconnect sT t t'
  | _, _ => False
  end.
Proof.
move/iter_findex <-; elim: (findex _ _ _) => [|k IH] /=.
  by case: x => [f|[l t]]; [exact: connect0 | split=> //; exact: connect0].
move: IH; case: x => [f|[l t]]; case: (iter k _ _) => [g|[l' t']] //=.
  by move/connect_trans; apply; exact: fconnect1.
by case=> <- c; split=> //; apply: connect_trans c _; exact: fconnect1.
Qed.

Lemma completed_simple : simple_world W -> simple_world completed_map.
Proof.
move=> S x y /same_vertex_completed; case: x y => [f|[l t]] [g|[l' t']] //=; last first.
  case=> <- c.
  case: (t =P stem) => [->|_]; case: (t' =P stem) => [->|_] //; move/same_vertex_completed => //=.
  by case=> _ c'; rewrite (simple_piece c c').
move=> c; case: insubP => [lf _ fE|nf]; case: insubP => [lg _ gE|ng] /same_vertex_completed //=.
  by case=> E _; rewrite -fE -gE E.
case Ef: (ends f) nf => [f'|] // _; case Eg: (ends g) ng => [g'|] //= _ c'.
congr inl; apply: (place_of_inj c); apply: S; first exact: place_of_vertex.
by rewrite -(place_of_end Ef) -(place_of_end Eg); exact: place_of_vertex.
Qed.

Lemma card_completed_world : #|completed_world| = #|folded_log| + #|loose ends| * #|T|.
Proof. exact: card_completion. Qed.
End Plug.
End Open.

(* the two ways in which every open dart is completed: by a path of one edge, and by one of two *)
Lemma leaf_end (t : unit) : (id t == t) = (t == tt).
Proof. by case: t. Qed.

Lemma leaf_connected (t : unit) : connect (adjacent id id) tt t.
Proof. by case: t; exact: connect0. Qed.

Lemma leaf_simple (t t' : unit) : fconnect id t t' -> fconnect id (id t) (id t') -> t = t'.
Proof. by case: t t' => [] []. Qed.

(* None: the stem, Some true: the other dart at its vertex, Some false: the dart at the end *)
Definition path_sigma (t : option bool) : option bool :=
  match t with None => Some true | Some true => None | Some false => Some false end.
Definition path_alpha : option bool -> option bool := omap negb.

Lemma path_sigma_inj : injective path_sigma.
Proof. by move=> [[]|] [[]|]. Qed.

Lemma path_alphaK : involutive path_alpha.
Proof. by move=> [[]|]. Qed.

Lemma path_end t : (path_alpha t == t) = (t == None).
Proof. by case: t => [[]|]. Qed.

Lemma path_connected t : connect (adjacent path_sigma path_alpha) None t.
Proof.
case: t => [[]|]; last exact: connect0; first exact: connect1.
by apply: (@connect_trans _ _ (Some true)); exact: connect1.
Qed.

Lemma path_turn k t : (iter k path_sigma t == Some false) = (t == Some false).
Proof. by elim: k => //= k <-; case: (iter k _ _) => [[]|]. Qed.

Lemma path_simple t t' :
  fconnect path_sigma t t' -> fconnect path_sigma (path_alpha t) (path_alpha t') -> t = t'.
Proof.
move=> /iter_findex H /iter_findex K.
have := path_turn (findex path_sigma t t') t; rewrite H.
have := path_turn (findex path_sigma (path_alpha t) (path_alpha t')) (path_alpha t); rewrite K.
by case: t t' {H K} => [[]|] [[]|].
Qed.

Section TwoWorlds.
Variables (L : log) (W : lighthouse_world).
Hypothesis A : agrees W L.

Definition with_leaves : lighthouse_world :=
  completed_world A (@inj_id unit) (fun t => erefl) leaf_end leaf_connected.

Definition with_paths : lighthouse_world :=
  completed_world A path_sigma_inj path_alphaK path_end path_connected.

Theorem open_dart_two_worlds (p : log_dart L) : ~~ dart_settled p ->
  [/\ agrees with_leaves L, agrees with_paths L & edges with_leaves <> edges with_paths].
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

Lemma completions_in_universe L W (A : agrees W L) u : in_universe u W ->
  in_universe u (with_leaves A) /\ in_universe u (with_paths A).
Proof.
case: u => // S; split; apply: completed_simple => //; first exact: leaf_simple.
exact: path_simple.
Qed.

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
Section Explorer.
Variables (E : Type) (meaning : E -> rooted_map) (X : explorer percept E).

(* an explorer that finds the map in two worlds that agree with its log: they are the same map *)
Theorem one_log_one_map (W W1 W2 : lighthouse_world) fuel t e z :
  finds_map meaning X (rooted (@start W1)) (@percept_of W1) ->
  finds_map meaning X (rooted (@start W2)) (@percept_of W2) ->
  episode X (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) ->
  agrees W1 (log_of W t) -> agrees W2 (log_of W t) -> same_map (rooted (@start W1)) (rooted (@start W2)).
Proof.
move=> F1 F2 R; have same (V : lighthouse_world) : agrees V (log_of W t) ->
    finds_map meaning X (rooted (@start V)) (@percept_of V) ->
    wellformed (meaning e) /\ same_map (meaning e) (rooted (@start V)).
  move=> A [n [t1 [e1 [z1 [R1 We I]]]]]; have P : percept_of (@start V) = percept_of (@start W).
    by have := congr1 (head (0, None)) A; case: (t).
  have R0 : explore X (rooted (@start W)) (@percept_of W) fuel [:: percept_of (@start W)] (@start W)
    = (t, Some e, z) by [].
  have R' : episode X (rooted (@start V)) (@percept_of V) fuel = (t, Some e, walk (unzip1 t) (@start V)).
    by have := explore_replay R0 (etrans A (f_equal (cons^~ _) (esym P))); rewrite -P.
  have := explore_more fuel R1; rewrite addnC (explore_more n R') => -[_ ee _]; subst e1.
  by split.
move=> /same/(_ F1)[We I1] /same/(_ F2)[_ I2]; apply: same_map_join We _ I1 I2.
exact: rooted_wellformed.
Qed.

Theorem explorer_log_folds u : finds_all_maps u meaning X -> forall W, in_universe u W ->
  forall fuel t e z,
  episode X (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) -> no_open_dart (log_of W t).
Proof.
move=> F W U fuel t e z R p; have [//|np] := boolP (dart_settled p); have A := episode_agrees R.
have [A1 A2 ne] := open_dart_two_worlds A np; have [U1 U2] := completions_in_universe A U.
case: ne; apply: same_map_edges; exact: one_log_one_map (F _ U1) (F _ U2) R A1 A2.
Qed.
End Explorer.
