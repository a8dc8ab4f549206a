(* ---------------------------------------------------------------------------------------------
   Bouquets, v0 at a distance: what an explorer can learn there, the way back included.     Section VI

   v0 has degree 1 and hangs at a vertex with c = k+1 loops, whose 2c ends are matched in any of the (2c-1)!!
   ways.  That vertex has no marker: only at v0 the robot learns where it is.

     loop_matching k      a way to match them.
     hanging a            the world with the loops matched by a.
     tells b              1, 2, 3, 4, 6, 9, 13, ...: tells (b-1) + tells (b-3).
     told_anywhere        so many of these worlds, at most, are told apart with b motions; from v0,
                          where the first two motions show nothing, tells (b-2).
     same_hanging         different matchings are different maps.
     least_motions w      the least b with w <= tells (b-2).
     bouquet_needs        so many motions in one of the bouquets with c loops, where w = (2c-1)!!.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers MassFormula PathWorlds.
From Bounds Require Import Gluings.
From Allworlds Require Import Algorithm Refinement Policies.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- The recurrence ---- *)
Fixpoint tells b :=
  match b with
  | 0 => 1 | 1 => 2 | 2 => 3
  | (b'.+2 as b2).+1 => tells b2 + tells b'
  end.

Lemma tells_grows b : tells b <= tells b.+1.
Proof. by case: b => [|[|b]] //; exact: leq_addr. Qed.

Lemma tells_le b b' : b <= b' -> tells b <= tells b'.
Proof. by move/subnK<-; elim: (b' - b) => // j IH; exact: leq_trans IH (tells_grows _). Qed.

Lemma tells_gt0 b : 0 < tells b.
Proof. exact: (@tells_le 0). Qed.

Lemma tells_home b : tells b + tells (b - 2) = tells b.+1.
Proof. by case: b => [|[|b]] //; rewrite subSS subSS subn0. Qed.

(* ---- The worlds ---- *)
Section Bouquets.
Variable k : nat.
Local Notation loop_end := 'I_(k.*2.+2).

Definition loop_matching := {b : {ffun loop_end -> loop_end} | pairs_up setT b}.

Lemma matchings_counted : #|{: loop_matching}| = pairings k.*2.+2.
Proof. by rewrite card_sig -[in RHS](card_ord k.*2.+2) -cardsT -pairings_counted cardsE. Qed.

Section OneWorld.
Variable a : loop_matching.

Lemma matched_back : involutive (val a).
Proof. by case/pairs_upP: (valP a). Qed.

Lemma matched_apart i : val a i != i.
Proof. by case/pairs_upP: (valP a) => _ ->; rewrite inE. Qed.

Lemma loops_connected i j : connect (adjacent (@after k.*2.+1) (val a)) i j.
Proof.
apply: connect_sub (bouquet_all i j) => x y /eqP <-.
by apply: connect1; rewrite /adjacent eqxx.
Qed.

Definition loops_map := CombinatorialMap (@after_inj k.*2.+1) matched_back matched_apart loops_connected.
Definition loops := @LighthouseWorld loops_map ord0 ord0 (connect0 _ _).
Definition hanging := longer loops.
End OneWorld.

(* ---- What is sensed there ---- *)
Local Notation dart := (loop_end + bool)%type.
Local Notation senses := (fun a : loop_matching => @percept_of (hanging a)).
Local Notation worlds := (fun a : loop_matching => rooted (@start (hanging a))).
Definition at_v0 : dart := inr false.

Lemma not_v0 : (inr true : dart) <> at_v0.
Proof. by []. Qed.

Lemma turns_alike a a' j (x : dart) :
  iter j (@sigma (hanging a)) x = iter j (@sigma (hanging a')) x.
Proof. by []. Qed.

Lemma turn_v0 a j : iter j (@sigma (hanging a)) at_v0 = at_v0.
Proof. by elim: j => // j IH; rewrite iterS IH. Qed.

Lemma one_vertex a (x y : hanging a) : x <> at_v0 -> y <> at_v0 -> at_same_vertex x y.
Proof.
have R (i j : loops a) : froot sigma i = froot sigma j.
  by apply/eqP; rewrite (root_connect (fconnect_sym sigma_inj)); exact: bouquet_all.
move=> nx ny; rewrite old_vertexE; apply/eqP; case: x y nx ny => [i|[]] [j|[]] //= _ _; congr Some; exact: R.
Qed.

Lemma bearing_v0 a : bearing (at_v0 : hanging a) = Some 0.
Proof. by rewrite /bearing /at_same_vertex connect0 findex0. Qed.

Lemma no_bearing a (x : hanging a) : x <> at_v0 -> bearing x = None.
Proof. by rewrite /bearing old_vertexE; case: x => [i|[]]. Qed.

Variable a0 : loop_matching.
Definition home_percept : percept := @percept_of (hanging a0) at_v0.
Definition away_percept : percept := @percept_of (hanging a0) (inr true).

Lemma sensed_home a : senses a at_v0 = home_percept.
Proof. by rewrite /home_percept /percept_of !bearing_v0. Qed.

Lemma sensed_away a x : x <> at_v0 -> senses a x = away_percept.
Proof.
move=> nx; rewrite /away_percept /percept_of !no_bearing //; congr (_, _).
have : @degree (hanging a) x = @degree (hanging a) (inr true) by apply: degree_same; exact: one_vertex.
by move=> ->.
Qed.

Lemma sensed_apart : home_percept <> away_percept.
Proof. by rewrite /home_percept /away_percept /percept_of bearing_v0 no_bearing. Qed.

(* ---- How many are told apart ---- *)
Variables (E : Type) (X : explorer percept E).
Local Notation told := (logs_differ X worlds senses).

Theorem told_anywhere b :
  (forall seen (d : forall a, carrier (worlds a)) (A : {set loop_matching}),
     told b seen d A -> #|A| <= tells b) /\
  (forall seen (d : forall a, carrier (worlds a)) (A : {set loop_matching}),
     (forall a, a \in A -> d a = at_v0) -> told b seen d A -> #|A| <= tells (b - 2)).
Proof.
have [n] := ubnP b; elim: n b => // n IH b; rewrite ltnS => lb.
split=> seen d A.
  case: b lb => [|b] lb; first exact: told_by_no_motion.
  case E0: (X seen) => [j|e] T; last by apply: leq_trans (told_by_stopping E0 T) (tells_gt0 _).
  have [anywhere home] := IH b lb.
  pose at_home := [set a in A | senses a (led worlds j d a) == home_percept].
  pose away := [set a in A | senses a (led worlds j d a) == away_percept].
  have h : #|at_home| <= tells (b - 2).
    apply: (home (rcons seen home_percept) (led worlds j d)); last exact: told_step E0 T.
    move=> a; rewrite inE => /andP[_ /eqP s]; apply/eqP; apply/negP=> /negP /eqP n0.
    by apply: sensed_apart; rewrite -s sensed_away.
  have w : #|away| <= tells b.
    by apply: (anywhere (rcons seen away_percept) (led worlds j d)); exact: told_step E0 T.
  rewrite -tells_home; apply: leq_trans (leq_add w h); rewrite -cardsUI; apply: leq_trans (leq_addr _ _).
  apply: subset_leq_card; apply/subsetP=> a aA; rewrite !inE aA /=.
  case: (led worlds j d a =P at_v0) => [->|n0]; first by rewrite sensed_home eqxx orbT.
  by rewrite sensed_away ?eqxx.
move=> at0 T; case: b lb T => [|b] lb T; first exact: told_by_no_motion T.
case E0: (X seen) => [j|e]; last by apply: leq_trans (told_by_stopping E0 T) (tells_gt0 _).
(* into the vertex with the loops *)
have into a : a \in A -> led worlds j d a = inr true.
  by move=> aA; rewrite /led at0 // /motion_in /= turn_v0.
have shows a : a \in A -> senses a (led worlds j d a) = away_percept.
  by move=> aA; rewrite into //; exact: sensed_away not_v0.
move: (told_on E0 shows T) => {}T.
case: b lb T => [|b] lb T; first exact: told_by_no_motion T.
rewrite !subSS subn0; move: (rcons seen _) T => seen' T.
case E1: (X seen') => [j'|e]; last by apply: leq_trans (told_by_stopping E1 T) (tells_gt0 _).
have [anywhere home] := IH b (leq_trans (leqnSn _) lb).
pose x := iter j' (@sigma (hanging a0)) (inr true).
have out a : a \in A -> led worlds j' (led worlds j d) a = @alpha (hanging a) x.
  by move=> aA; rewrite [LHS]/led into // /motion_in (turns_alike _ a0).
case: (x =P inr true) => [xB|nB].
  have home' a : a \in A -> led worlds j' (led worlds j d) a = at_v0 by move=> aA; rewrite out // xB.
  apply: leq_trans (tells_le (leq_subr 2 b)); apply: (home _ _ _ home').
  by apply: told_on E1 _ T => a aA; rewrite home' // sensed_home.
apply: anywhere; apply: told_on E1 _ T => a aA; rewrite out //; apply: sensed_away.
by case: (x) nB => [i|[]].
Qed.

(* ---- They are different worlds, and an explorer that finds their maps tells them apart ---- *)
Lemma same_hanging a a' : same_map (worlds a) (worlds a') -> a = a'.
Proof.
move=> [x _ [f [g [F _ r]]]].
have fs y : f (@sigma (hanging a) y) = @sigma (hanging a') (f y) by have [] := F y isT.
have fa y : f (@alpha (hanging a) y) = @alpha (hanging a') (f y) by have [] := F y isT.
have fj j y : f (iter j (@sigma (hanging a)) y) = iter j (@sigma (hanging a')) (f y).
  by elim: j => //= j IH; rewrite fs IH.
have f0 : f at_v0 = at_v0.
  have := fs at_v0; rewrite [sigma _]/=; case: (f at_v0) => [i|[]] //=; case: ifP => // _ [e].
  have := after_turn 1 i; rewrite /= -e => e1.
  have /eqP : i + 1 = i + 0 %[mod k.*2.+2] by rewrite -e1 addn0 modn_small.
  by rewrite eqn_modDl mod0n modn_small.
have f1 : f (inr true) = inr true by have := fa at_v0; rewrite f0.
have fid y : f y = y.
  case: (y =P at_v0) => [->//|/(@one_vertex a (inr true) y not_v0) /iter_findex <-].
  by rewrite fj f1.
apply/val_inj/ffunP=> i; have := fa (inl i); rewrite !fid => -[]; exact.
Qed.

Variable meaning : E -> rooted_map.
Hypothesis finds_maps : forall a, finds_map meaning X (worlds a) (senses a).

Definition stops_within b a := exists t e z, episode X (worlds a) (senses a) b = (t, Some e, z).

Theorem told_by_finding b : (forall a, stops_within b a) -> pairings k.*2.+2 <= tells (b - 2).
Proof.
move=> S; rewrite -matchings_counted -cardsT.
apply: (proj2 (told_anywhere b) [:: home_percept] (fun=> at_v0)) => // a a' _ _.
have ep a1 : log_with X worlds senses b [:: home_percept] (fun=> at_v0) a1 =
    (episode X (worlds a1) (senses a1) b).1 by rewrite /episode -(sensed_home a1).
rewrite !ep; have [t [e [z R]]] := S a; have [t' [e' [z' R']]] := S a'; rewrite R R' /= => -[_ ee]; subst e'.
have [n [u [x [y [F W I]]]]] := finds_maps a; have [_ ex _] := explore_once R F.
have [n' [u' [x' [y' [F' W' I']]]]] := finds_maps a'; have [_ ex' _] := explore_once R' F'.
subst x x'; apply: same_hanging; exact: same_map_join W (rooted_wellformed _) I I'.
Qed.

(* the number of motions that are needed *)
Definition least_motions w := find (fun b => w <= tells (b - 2)) (iota 0 w.+2).

Theorem needs_motions : exists a, forall fuel t e z,
  episode X (worlds a) (senses a) fuel = (t, Some e, z) -> least_motions (pairings k.*2.+2) <= size t.
Proof.
set w := pairings _; have stops a : exists n, stops_within n a.
  by have [n [t [e [z [R _ _]]]]] := finds_maps a; exists n, t, e, z.
have [fuel F] := fin_all_exists stops.
pose n := \max_a fuel a; have {}stops a : stops_within n a.
  have [t [e [z R]]] := F a; exists t, e, z.
  by rewrite -(subnKC (leq_bigmax a : fuel a <= n)); exact: explore_more R.
pose walked a := size (episode X (worlds a) (senses a) n).1.1.
have once a b t e z : episode X (worlds a) (senses a) b = (t, Some e, z) -> size t = walked a.
  move=> R; have [t' [e' [z' R']]] := stops a.
  by have [-> _ _] := explore_once R R'; rewrite /walked R'.
case: (boolP [exists a, least_motions w <= walked a]) => [/existsP[a le]|/existsPn N].
  by exists a => b t e z /once->.
have [b' lb] : exists b', least_motions w = b'.+1.
  exists (least_motions w).-1; rewrite prednK //.
  by apply: leq_ltn_trans (leq0n (walked a0)) _; rewrite ltnNge.
have bounded : w <= tells (b' - 2).
  apply: told_by_finding => a; have [t [e [z R]]] := stops a; exists t, e, z.
  have := N a; rewrite -ltnNge lb ltnS => lw; rewrite -(subnKC lw); apply: explore_more.
  by move: lw; rewrite /walked R => _; exact: explore_exact R.
have := @before_find _ 0 (fun b => w <= tells (b - 2)) (iota 0 w.+2) b'.
rewrite -/(least_motions w) lb ltnSn => /(_ isT); rewrite nth_iota ?add0n ?bounded //.
by rewrite -ltnS -lb ltnS -[X in _ <= X](size_iota 0); exact: find_size.
Qed.
End Bouquets.

Lemma tells_more b : b < tells b.
Proof.
elim: b => // b IH; rewrite -tells_home -addn1; apply: leq_add; first exact: IH.
exact: tells_gt0.
Qed.

Theorem least_motionsP w b : (least_motions w <= b) = (w <= tells (b - 2)).
Proof.
pose enough b := w <= tells (b - 2).
have some : has enough (iota 0 w.+2).
  apply/hasP; exists w.+1; rewrite ?mem_iota ?add0n ?leqnn // /enough.
  by have := tells_more (w.+1 - 2); case: (w) => // v; rewrite !subSS subn0.
have lt : least_motions w < w.+2 by rewrite -(size_iota 0 w.+2) -has_find.
apply/idP/idP=> [le|en].
  have := nth_find 0 some; rewrite nth_iota // add0n => en; apply: leq_trans en (tells_le _).
  exact: leq_sub2r.
rewrite leqNgt; apply/negP=> l; have := before_find 0 l; rewrite nth_iota ?add0n ?en //.
exact: ltn_trans l lt.
Qed.

(* for c = 2, ..., 6 *)
Lemma least_motions_of_bouquets :
  [seq least_motions (pairings c.*2) | c <- iota 2 5] = [:: 4; 9; 14; 20; 26].
Proof. by vm_compute. Qed.

(* one way to match the loops, and an explorer that finds the maps of all these worlds *)
Lemma nested_pairs_up k : pairs_up setT (finfun (@rev_ord k.*2.+2)).
Proof.
apply/pairs_upP; split=> i; rewrite !ffunE ?rev_ordK //.
by rewrite (negbTE (bouquet_alpha_neq i)) inE.
Qed.
Definition nested k : loop_matching k := Sub _ (nested_pairs_up k).

Theorem bouquet_needs k E (meaning : E -> rooted_map) (X : explorer percept E) :
  (forall a : loop_matching k, finds_map meaning X (rooted (@start (hanging a))) (@percept_of (hanging a))) ->
  exists a : loop_matching k, forall fuel t e z,
  episode X (rooted (@start (hanging a))) (@percept_of (hanging a)) fuel = (t, Some e, z) ->
  least_motions (pairings k.*2.+2) <= size t.
Proof. exact: needs_motions (nested k) E X meaning. Qed.

Theorem hanging_sizes k (a : loop_matching k) :
  [/\ edges (hanging a) = k.+2, vertices (hanging a) = 2 & degree (@start (hanging a)) = 1].
Proof.
split; last first.
- rewrite /degree /order -(card1 (at_v0 k : hanging a)); apply: eq_card => x; rewrite [RHS]inE.
  rewrite -[LHS]/(at_same_vertex (@start (hanging a)) x) old_vertexE.
  by case: x => [i|[]].
- by rewrite vertices_longer; congr _.+1; exact: (vertices_bouquet k).
by rewrite edges_longer; congr _.+1; apply: double_inj; rewrite edges_double card_ord.
Qed.

Theorem told_in_bouquets k E (X : explorer percept E) b (A : {set loop_matching k}) :
  {in A &, injective (fun a : loop_matching k =>
     (episode X (rooted (@start (hanging a))) (@percept_of (hanging a)) b).1)} -> #|A| <= tells (b - 2).
Proof.
by move=> T; apply: (proj2 (told_anywhere (nested k) X b) [:: home_percept (nested k)] (fun=> at_v0 k)).
Qed.

Example algorithm1_in_two_loops : exists a : loop_matching 1, forall fuel t e z,
  episode (algorithm1 fifo) (rooted (@start (hanging a))) (@percept_of (hanging a)) fuel = (t, Some e, z) ->
  4 <= size t.
Proof.
have [a H] := bouquet_needs (fun a : loop_matching 1 => right_finds_map (@algorithm1_right (hanging a) fifo)).
exists a => fuel t e z /H; exact: leq_trans.
Qed.
