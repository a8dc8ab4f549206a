(* ---------------------------------------------------------------------------------------------
   Worlds that sensors at v0 do not tell apart, where the word is a proper power or blank.

   A sheet is made of p edges that join v0 to a vertex u, of degree p + 2, and of a loop at u:
     stem j false         the dart of v0 that begins edge j;
     stem j true          its other end, dart j of u;
     bud false, bud true  the last two darts of u, the two ends of its loop.
   A flower is made of several sheets.  Two permutations of the sheets say how they are put together:
     around i             whose darts come after those of sheet i round v0;
     across i             whose u is at the other end of the last dart of the u of sheet i.
   If around i = i each sheet has a v0 of its own, if across i = i a loop of its own.
     onward i             the next sheet, the first after the last.
     in_turn n, one_after_the_other n   n + 1 sheets round one v0: with loops; or each u joined to the next.
     alone, two_stems     one sheet; two, with a v0 each, their u joined by two edges.
     flower p' i          p is p' + 1; seen from the first dart of sheet i, which is the door.

     sensed_in_sheets     where p is a period of the word, the same is sensed in all sheets.
     power_twins          where the word for degree d is u^k, k >= 2: two worlds with d + k edges, v0 of
                          degree d, that are indistinguishable and different maps.
     blank_twins          where the word for degree 1 is blank: two worlds with 2 and 4 edges.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Words Sensors.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* the next one, the first after the last *)
Definition onward n (i : 'I_n.+1) : 'I_n.+1 := inord (i.+1 %% n.+1).

Lemma onward_val n (i : 'I_n.+1) : onward i = i.+1 %% n.+1 :> nat.
Proof. by rewrite inordK // ltn_mod. Qed.

Lemma iter_onward n (i : 'I_n.+1) b : iter b (@onward n) i = (i + b) %% n.+1 :> nat.
Proof.
elim: b => [|b IH] /=; first by rewrite addn0 modn_small.
by rewrite onward_val IH -addn1 modnDml addn1 addnS.
Qed.

Lemma onward_inj n : injective (@onward n).
Proof.
move=> i j /(congr1 (iter n (@onward n))); rewrite -!iterSr => E; apply: val_inj => /=.
by have := congr1 (@nat_of_ord _) E; rewrite !iter_onward !modnDr !modn_small.
Qed.

Lemma onward_reaches n (i j : 'I_n.+1) : exists b, iter b (@onward n) i = j.
Proof.
exists (n.+1 - i + j); apply: val_inj; rewrite /= iter_onward addnA subnKC ?(ltnW (ltn_ord i)) //.
by rewrite modnDl modn_small.
Qed.

(* ---- Flowers ---- *)
Record sheets := Sheets {
  sheet :> finType;
  around : sheet -> sheet;
  across : sheet -> sheet;
  around_inj : injective around;
  across_inj : injective across;
  sheets_connected : forall i j, connect (adjacent around across) i j }.
Arguments around {s} _.
Arguments across {s} _.
Arguments around_inj {s} [x1 x2] _.
Arguments across_inj {s} [x1 x2] _.
Arguments sheets_connected {s} i j.

Section Flower.
Variables (X : sheets) (p' : nat).
Local Notation p := p'.+1.

(* the darts of a sheet *)
Definition part := ('I_p * bool + bool)%type.
Definition stem j c : part := inl (j, c).
Definition bud c : part := inr c.
Definition flower_dart := (X * part)%type.

(* clockwise, and across, in one sheet *)
Definition part_sigma (t : part) : part := match t with
  | inl (j, false) => stem (onward j) false
  | inl (j, true) => if j == ord_max then bud false else stem (onward j) true
  | inr false => bud true
  | inr true => stem ord0 true
  end.
Definition part_alpha (t : part) : part := match t with
  | inl (j, c) => stem j (~~ c)
  | inr c => bud (~~ c)
  end.

Definition flower_sigma (x : flower_dart) : flower_dart :=
  (match x.2 with inl (j, false) => if j == ord_max then around x.1 else x.1 | _ => x.1 end,
   part_sigma x.2).
Definition flower_alpha (x : flower_dart) : flower_dart :=
  (match x.2 with inl _ => x.1 | inr true => across x.1 | inr false => finv across x.1 end,
   part_alpha x.2).

Lemma onward_first (j : 'I_p) : onward j = ord0 -> j = ord_max.
Proof.
move/(congr1 val); rewrite /= onward_val => E; apply: val_inj => /=.
move: (ltn_ord j); rewrite ltnS leq_eqVlt => /orP[/eqP //|lt].
by move: E; rewrite modn_small.
Qed.

Lemma part_sigma_inj : injective part_sigma.
Proof.
have N (j : 'I_p) : j != ord_max -> onward j <> ord0 by move/eqP=> H /onward_first.
move=> [[j []]|[]] [[j' []]|[]] //=; try case: (j =P ord_max) => [->|/eqP nj];
  try case: (j' =P ord_max) => [->|/eqP nj'] //.
all: try discriminate.
all: try by case=> /onward_inj ->.
- by case=> /N; case/(_ nj).
- by case=> /esym /N; case/(_ nj').
Qed.

Lemma flower_sigma_inj : injective flower_sigma.
Proof.
move=> [i t] [j t'] /= [E /part_sigma_inj T]; move: T E => <- {t'}.
by case: t => [[k []]|[]]; try case: ifP => _; try move/around_inj; move=> ->.
Qed.

Lemma flower_alphaK : involutive flower_alpha.
Proof.
move=> [i [[j c]|[]]] /=; rewrite /flower_alpha /= ?negbK //.
  by rewrite (finv_f across_inj).
by rewrite (f_finv across_inj).
Qed.

Lemma flower_alpha_neq x : flower_alpha x != x.
Proof. by case: x => [i [[j []]|[]]]; apply/eqP; case. Qed.

(* round v0: from the first stem of a sheet to the others, and to the next sheet *)
Lemma stem_reached i j : fconnect flower_sigma (i, stem ord0 false) (i, stem j false).
Proof.
case: j => j; elim: j => [|j IH] lt.
  have -> : Ordinal lt = ord0 by exact: val_inj.
  exact: connect0.
apply: connect_trans (IH (ltnW lt)) (connect1 _); apply/eqP; rewrite /= /flower_sigma /=.
case: eqP => [[E]|_]; first by exfalso; move: (lt); rewrite E ltnn.
by congr (_, inl (_, _)); apply: val_inj; rewrite /= onward_val /= modn_small.
Qed.

Lemma stem_last i : flower_sigma (i, stem ord_max false) = (around i, stem ord0 false).
Proof.
rewrite /flower_sigma /= eqxx; congr (_, inl (_, _)); apply: val_inj.
by rewrite /= onward_val /= modnn.
Qed.

Local Notation joined := (connect (adjacent flower_sigma flower_alpha)).

Lemma flower_connected x y : joined x y.
Proof.
have sym := adjacent_connect_sym flower_sigma_inj flower_alphaK.
have byS z u : flower_sigma z = u -> joined z u by move<-; apply: connect1; rewrite /adjacent eqxx.
have byA z u : flower_alpha z = u -> joined z u by move<-; apply: connect1; rewrite /adjacent eqxx orbT.
pose base i : flower_dart := (i, stem ord0 false).
have stems i (j : 'I_p) : joined (base i) (i, stem j false).
  by apply: connect_sub (stem_reached i j) => z u /eqP; exact: byS.
have ends i (j : 'I_p) : joined (base i) (i, stem j true).
  by apply: connect_trans (stems i j) (byA _ _ _).
have bud0 i : joined (base i) (i, bud false).
  by apply: connect_trans (ends i ord_max) (byS _ _ _); rewrite /flower_sigma /= eqxx.
have bud1 i : joined (base i) (i, bud true) by apply: connect_trans (bud0 i) (byS _ _ _).
have all i t : joined (base i) (i, t).
  by case: t => [[j []]|[]]; [exact: ends | exact: stems | exact: bud1 | exact: bud0].
have turn i : joined (base i) (base (around i)).
  by apply: connect_trans (stems i ord_max) (byS _ _ _); exact: stem_last.
have cross i : joined (base i) (base (across i)).
  apply: connect_trans (bud1 i) _; rewrite sym; apply: connect_trans (bud0 (across i)) _; rewrite sym.
  exact: byA.
have bases i j : joined (base i) (base j).
  case/connectP: (sheets_connected i j) => q + ->; elim: q i => [|k q IH] i /=; first by rewrite connect0.
  by case/andP=> /orP[]/eqP-> /IH; apply: connect_trans.
case: x y => [i t] [j t']; apply: connect_trans (all j t'); apply: connect_trans (bases i j).
by rewrite sym.
Qed.

Definition flower_map :=
  CombinatorialMap flower_sigma_inj flower_alphaK flower_alpha_neq flower_connected.

(* seen from the first dart of a stem, which is the door *)
Definition flower i :=
  @LighthouseWorld flower_map (i, stem ord0 false) (i, stem ord0 false) (connect0 _ _).

Lemma flower_edges : edges flower_map = #|X| * p.+1.
Proof.
apply: double_inj; rewrite edges_double /= card_prod card_sum card_prod card_ord card_bool.
by rewrite -muln2 -mulnA [p.+1 * 2]mulSn addnC.
Qed.

(* ---- Turning ---- *)
Definition at_stem (t : part) := if t is inl (_, false) then true else false.

Lemma iter_part n (x : flower_map) : (iter n sigma x).2 = iter n part_sigma x.2.
Proof. by elim: n => //= n ->. Qed.

Lemma iter_at_stem n t : at_stem (iter n part_sigma t) = at_stem t.
Proof. by elim: n => //= n <-; case: (iter n _ _) => [[j []]|[]] //=; case: ifP. Qed.

(* round a u the sheet does not change; round v0 neither, if each sheet has its own *)
Lemma iter_off_stem n i t : ~~ at_stem t ->
  iter n (@sigma flower_map) (i, t) = (i, iter n part_sigma t).
Proof.
move=> N; elim: n => //= n ->; have := iter_at_stem n t; rewrite (negbTE N) /flower_sigma /=.
by case: (iter n _ _) => [[j []]|].
Qed.

Lemma iter_alone n i t : (forall i : X, around i = i) ->
  iter n (@sigma flower_map) (i, t) = (i, iter n part_sigma t).
Proof.
by move=> H; elim: n => //= n ->; rewrite /flower_sigma /= H; case: (iter n _ _) => [[j []]|] //; case: ifP.
Qed.

Lemma iter_stem n j : iter n part_sigma (stem j false) = stem (iter n (@onward p') j) false.
Proof. by elim: n => //= n ->. Qed.

Lemma same_vertex_part (x y : flower_map) : at_same_vertex x y -> at_stem x.2 = at_stem y.2.
Proof. by move/iter_findex=> <-; rewrite iter_part iter_at_stem. Qed.

(* ---- All stems at one v0 ---- *)
Hypothesis around_reaches : forall i j : X, exists b, iter b around i = j.

Lemma stems_together (x y : flower_map) : at_stem x.2 -> at_stem y.2 -> at_same_vertex x y.
Proof.
pose base i : flower_map := (i, stem ord0 false).
have stems i (j : 'I_p) : at_same_vertex (base i) (i, stem j false) by exact: stem_reached.
have bases i j : at_same_vertex (base i) (base j).
  have [b <-] := around_reaches i j; elim: b => [|b IH] /=; first exact: connect0.
  apply: connect_trans IH (connect_trans (stems _ ord_max) (connect1 _)).
  by apply/eqP; exact: stem_last.
case: x y => [i [[j []]|b]] [i' [[j' []]|b']] //= _ _; apply: connect_trans (stems i' j').
by apply: connect_trans (bases i i'); rewrite -/(at_same_vertex _ _) at_same_vertex_sym; exact: stems.
Qed.

Lemma stem_degree (x : flower_map) : at_stem x.2 -> degree x = #|X| * p.
Proof.
move=> Sx; rewrite /degree /order -[in RHS](card_ord p).
have inj : injective (fun q : X * 'I_p => (q.1, stem q.2 false) : flower_map).
  by move=> [i j] [i' j'] /= [-> ->].
have -> : #|X| * #|'I_p| = #|{: X * 'I_p}| by rewrite card_prod.
rewrite -(card_codom inj); apply: eq_card => y.
rewrite -[LHS]/(at_same_vertex x y); apply/idP/codomP=> [/same_vertex_part|[[i j] ->]]; last first.
  exact: stems_together.
by rewrite Sx; case: y => [i [[j []]|b]] //= _; exists (i, j).
Qed.

Variables (w : nat -> nat -> nat) (i0 : X).
Hypothesis periodic : forall b, b < #|X| * p -> w (#|X| * p) b = w (#|X| * p) (b %% p).
Local Notation r := ((i0, stem ord0 false) : flower_map).

(* what is sensed is the same in all sheets *)
Lemma sensed_in_sheets i i' t :
  (degree ((i, t) : flower_map), at_v0 w r (i, t)) = (degree ((i', t) : flower_map), at_v0 w r (i', t)).
Proof.
case: (boolP (at_stem t)) => St; last first.
  congr (_, _); last first.
    rewrite /at_v0; case: ifP => [/same_vertex_part|_]; first by rewrite /= (negbTE St).
    by case: ifP => // /same_vertex_part; rewrite /= (negbTE St).
  apply: degree_transfer => j; rewrite !iter_off_stem // !xpair_eqE !eqxx //.
rewrite !stem_degree //; congr (_, _); rewrite /at_v0 !stems_together // !stem_degree //.
case: t St => [[j []]|b] // _.
have low k : let b := findex sigma ((k, stem j false) : flower_map) r in
    b < #|X| * p /\ (j + b) %% p = 0.
  have c : at_same_vertex ((k, stem j false) : flower_map) r by exact: stems_together.
  rewrite /= -(@stem_degree (k, stem j false)) //; split; first exact: findex_max c.
  have /(congr1 snd) := iter_findex c; rewrite iter_part /= iter_stem => -[] /(congr1 val) /=.
  by rewrite iter_onward.
have [l E] := low i; have [l' E'] := low i'; rewrite (periodic l) (periodic l').
by congr (w _ _); apply/eqP; rewrite -(eqn_modDl j) E E'.
Qed.
End Flower.

(* ---- Sheets ---- *)
Lemma onward_joined n (f : 'I_n.+1 -> 'I_n.+1) (i j : 'I_n.+1) : connect (adjacent (@onward n) f) i j.
Proof.
have [b <-] := onward_reaches i j; elim: b => [|b IH] /=; first exact: connect0.
by apply: connect_trans IH (connect1 _); rewrite /adjacent eqxx.
Qed.

Definition in_turn n :=
  @Sheets _ (@onward n) id (@onward_inj n) (fun _ _ => id) (@onward_joined n id).
Definition one_after_the_other n :=
  @Sheets _ (@onward n) (@onward n) (@onward_inj n) (@onward_inj n) (@onward_joined n (@onward n)).

Lemma unit_joined (i j : unit) : connect (adjacent id id) i j.
Proof. by case: i; case: j; exact: connect0. Qed.

Lemma bool_joined (i j : bool) : connect (adjacent id negb) i j.
Proof.
case: (i =P j) => [->|/eqP N]; first exact: connect0.
by apply: connect1; move: i j N => [] [].
Qed.

Definition alone := @Sheets _ id id (fun _ _ => id) (fun _ _ => id) unit_joined.
Definition two_stems := @Sheets _ id negb (fun _ _ => id) negb_inj bool_joined.

(* ---- A loop in the one, none in the other ---- *)
Lemma same_map_loop (G H : combinatorial_map) (d : G) (e : H) : same_map (rooted d) (rooted e) ->
  forall x : G, at_same_vertex x (alpha x) -> exists y : H, at_same_vertex y (alpha y).
Proof.
case=> z _ [f [g [F _ _]]] x /iter_findex E; exists (f x).
have fs n u : f (iter n sigma u) = iter n sigma (f u).
  by elim: n => //= n <-; have [_ _ -> _] := F (iter n sigma u) isT.
have [_ _ _ /= <-] := F x isT; rewrite -E fs; exact: fconnect_iter.
Qed.

Lemma loop_in_turn n p' : let x := (ord0, bud p' true) : flower_map (in_turn n) p' in
  at_same_vertex x (alpha x).
Proof. by rewrite /= at_same_vertex_sym; apply: connect1; apply/eqP. Qed.

Lemma onward_neq n (i : 'I_n.+2) : onward i <> i.
Proof.
move/(congr1 val); rewrite /= onward_val; case: (ltnP i.+1 n.+2) => [lt|le].
  by rewrite modn_small // => /esym/n_Sn.
have E : i.+1 = n.+2 by apply/eqP; rewrite eqn_leq le ltn_ord.
by move: E => [->]; rewrite modnn.
Qed.

Lemma no_loop_one_after n p' (y : flower_map (one_after_the_other n.+1) p') : ~~ at_same_vertex y (alpha y).
Proof.
apply/negP=> c; have := same_vertex_part c; case: y c => [i [[j []]|b]] //= /iter_findex E _.
move: E; rewrite iter_off_stem // /flower_alpha => -[]; case: b => E _; apply: (@onward_neq n i).
  exact: esym E.
by rewrite {1}E; exact: (f_finv (@onward_inj n.+1)).
Qed.

(* ---- Theorem 1, only if ---- *)
Theorem power_twins w d k v : 0 < d -> 1 < k -> word w d = flatten (nseq k v) ->
  exists W W' : lighthouse_world,
  [/\ degree (@start W) = d, edges W = d + k, edges W' = d + k,
      indistinguishable (at_v0 w) W W' & ~ same_map (rooted (@start W)) (rooted (@start W'))].
Proof.
move=> d0 k1 /power_periodic[D P]; case: k k1 D => [|[|n]] // _ D.
case: (size v) D P => [|p'] D P; first by rewrite D muln0 in d0.
pose W := flower p' (ord0 : in_turn n.+1); pose W' := flower p' (ord0 : one_after_the_other n.+1).
have reaches := @onward_reaches n.+1; have cX : #|in_turn n.+1| = n.+2 by rewrite card_ord.
have m (X : sheets) : #|X| = n.+2 -> edges (flower_map X p') = d + n.+2.
  by move=> c; rewrite flower_edges c mulnS addnC D.
exists W, W'; split.
- by rewrite (@stem_degree (in_turn n.+1)) // cX D.
- exact: (m (in_turn n.+1) cX).
- exact: (m (one_after_the_other n.+1) cX).
- exists (fun x y => x.2 = y.2); split=> // [[i t] [i' t'] /= <-|[i t] [i' t'] /= ->|[i t] [i' t'] /= ->] //.
  apply: (@sensed_in_sheets (in_turn n.+1) p' reaches w ord0 _ i i' t).
  by rewrite cX -D.
move/same_map_loop=> /(_ _ (loop_in_turn n.+1 p'))[y].
by rewrite (negbTE (no_loop_one_after y)).
Qed.

Lemma degree_1 (G : combinatorial_map) (x : G) : sigma x = x -> degree x = 1.
Proof. by move=> E; apply: order_least => //; [exact: sigma_inj | case=> [|[]]]. Qed.

Theorem blank_twins w : blank (word w 1) -> exists W W' : lighthouse_world,
  [/\ degree (@start W) = 1, edges W = 2, edges W' = 4,
      indistinguishable (at_v0 w) W W' & ~ same_map (rooted (@start W)) (rooted (@start W'))].
Proof.
rewrite /blank /= andbT => /eqP w0.
pose W := flower 0 (tt : alone); pose W' := flower 0 (false : two_stems).
have first (X : sheets) (i : X) : (forall j : X, around j = j) -> degree (@start (flower 0 i)) = 1.
  move=> H; apply: degree_1; rewrite /= /flower_sigma /= H; congr (_, inl (_, _)).
  by apply: val_inj; rewrite /= onward_val.
have zero (X : sheets) (i : X) (x : flower 0 i) : (forall j : X, around j = j) -> at_v0 w pointed x = 0.
  move=> H; rewrite /at_v0; case: ifP => // c; have lt := findex_max c.
  have D : degree x = 1 by rewrite -(degree_same c) first.
  by move: lt; rewrite -/(degree x) D; case: (findex _ _ _).
have mW : edges W = 2 by rewrite flower_edges card_unit.
have mW' : edges W' = 4 by rewrite flower_edges card_bool.
exists W, W'; split=> //; first exact: first.
  exists (fun x y => x.2 = y.2); split=> // [[i t] [i' t'] /= <-|[i t] [i' t'] /= ->|[i t] [i' t'] /= ->] //.
  rewrite /percept_by !zero //; congr (_, _); apply: degree_transfer => j.
  by rewrite !iter_alone // !xpair_eqE !eqxx.
by move/same_map_edges; rewrite mW mW'.
Qed.
