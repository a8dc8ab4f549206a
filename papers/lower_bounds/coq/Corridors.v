(* ---------------------------------------------------------------------------------------------
   Corridors: words that lead home from one dart only.                                 Section VI

     corridor F R hub hub_place   the world is a corridor: v0 (hub 0), 2F near hubs, F far ones, all of degree
                          R >= 12F+6; hub_place: how many darts clockwise from its first.
     in_dart, out_dart    two edges join a hub to the next: from its out-darts to the in-darts there.  The
                          others of a near hub are loops; those of far hubs lead to far hubs, in any way.
     home_word w d        w leads from d to v0, past no vertex twice;  passed w d: the darts on the way.
     falls w d            down the near hubs without a stop.
     home_word_falls      a home word of a far dart: at most F motions to hub 2F, then it falls.
     falling_letter       which motion leads down at a hub is known from the motion, and from which
                          out-dart.
     above z              twice the hub of z, and one more at an out-dart, from where the next motion leads
                          down nobody but the right walker: it falls by one a motion, at most.
     wrong_walkers        no other far dart is led to v0, at any time.
     home_words_part      home words of two far darts agree on at most F motions.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Coq Require Import Lia.
From Allworlds Require Import Model Maps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* sums and orders of natural numbers *)
Ltac numbers := intros; repeat match goal with
  | H : is_true (_ <= _) |- _ => (apply (elimT leP) in H)
  | H : is_true (@eq_op nat_eqType _ _) |- _ => (apply (elimT eqP) in H)
  end; change addn with Nat.add in *; change muln with Nat.mul in *; change subn with Nat.sub in *;
  first [lia | (apply/leP; lia) | (apply/eqP; lia)].

(* ---- Ways home ---- *)
Section HomeWords.
Variable W : lighthouse_world.

Fixpoint passed w (d : W) := d :: (if w is k :: w' then passed w' (motion k d) else [::]).
Lemma passed_cons k w d : passed (k :: w) d = d :: passed w (motion k d).
Proof. by []. Qed.

Definition home_word w (d : W) :=
  at_same_vertex start (walk w d) && pairwise (fun x y => ~~ at_same_vertex x y) (passed w d).

(* what is left of one on the way is one, from where the robot is then *)
Lemma home_word_suffix w w' d : home_word (w ++ w') d -> home_word w' (walk w d).
Proof.
elim: w d => [|k w IH] d //= H; apply: IH; move: H; rewrite /home_word passed_cons.
by case/andP=> /= -> /andP[_].
Qed.
End HomeWords.

Section Corridor.
Variables (F R : nat) (W : lighthouse_world) (hub hub_place : W -> nat).
Implicit Types (d x y z : W) (w : seq nat).
Local Notation N := (2 * F).

Definition in_dart d := (0 < hub d) && (hub_place d < 2).
Definition out_dart d := (0 < hub d < N + F) &&
  ((hub_place d + 4 * hub d == R) || (hub_place d + 4 * hub d + 2 == R)).

Record corridor : Prop := Corridor {
  degree_large : 12 * F + 6 <= R;
  hub_vertex : forall d e, at_same_vertex d e = (hub d == hub e);
  hub_start : hub start = 0;
  hub_last : forall d, hub d <= N + F;
  place_small : forall d, 0 < hub d -> hub_place d < R;
  place_sigma : forall d, 0 < hub d -> hub_place (sigma d) = (hub_place d).+1 %% R;
  place_inj : forall d e, hub d = hub e -> hub_place d = hub_place e -> d = e;
  leave_v0 : forall d, hub d = 0 -> hub (alpha d) = 1;
  way_in : forall d, in_dart d -> hub d = (hub (alpha d)).+1 /\
    (0 < hub (alpha d) -> out_dart (alpha d));
  way_out : forall d, out_dart d -> hub (alpha d) = (hub d).+1;
  near_loops : forall d, 0 < hub d <= N -> ~~ in_dart d -> ~~ out_dart d -> hub (alpha d) = hub d;
  far_edges : forall d, N < hub d -> ~~ in_dart d -> ~~ out_dart d -> N < hub (alpha d) }.

Hypothesis C : corridor.

Lemma hub_turn k d : hub (iter k sigma d) = hub d.
Proof. by apply/eqP; rewrite eq_sym -(hub_vertex C); exact: fconnect_iter. Qed.

Lemma place_turn k d : 0 < hub d -> hub_place (iter k sigma d) = (hub_place d + k) %% R.
Proof.
move=> h; elim: k => [|k IH]; first by rewrite addn0 modn_small // (place_small C).
by rewrite iterS (place_sigma C) ?hub_turn // IH -addn1 modnDml addn1 addnS.
Qed.

Lemma ring_turn k d : 0 < hub d -> iter (k %% R) sigma d = iter k sigma d.
Proof.
by move=> h; apply: (place_inj C); rewrite ?hub_turn // !place_turn // modnDmr.
Qed.

(* the motions that lead down from an out-dart: 4 l, ..., 4 l + 3 at hub l, two from each of them *)
Lemma falling_letter d k : out_dart d -> in_dart (iter k sigma d) ->
  exists e r, [/\ e < 2, r < 2, hub_place d + 4 * hub d + 2 * e = R & k %% R = 4 * hub d + 2 * e + r].
Proof.
move=> /andP[/andP[h0 hF] o] /andP[_]; rewrite place_turn // -modnDmr.
have [e e2 E] : exists2 e, e < 2 & hub_place d + 4 * hub d + 2 * e = R.
  by case/orP: o => /eqP o; [exists 0 | exists 1] => //; rewrite ?muln0 ?addn0 ?muln1.
have kR : k %% R < R by rewrite ltn_mod (leq_trans _ (degree_large C)) // addnS.
move: (k %% R) kR => q kR; case: (ltnP (hub_place d + q) R) => [l|l].
  by rewrite modn_small // => r; exfalso; move: E r hF e2 (degree_large C); clear; numbers.
have -> : (hub_place d + q) %% R = hub_place d + q - R.
  rewrite -{1}(subnK l) modnDr modn_small // ltn_subLR //.
  by apply: leq_trans (_ : hub_place d + R <= _); rewrite ?ltn_add2l ?leq_add2r // ltnW // (place_small C).
move=> r; exists e, (hub_place d + q - R); split=> //.
by clear C o; numbers.
Qed.

Lemma falling_apart d d' k k' : out_dart d -> out_dart d' -> k = k' %[mod R] ->
  in_dart (iter k sigma d) -> in_dart (iter k' sigma d') -> d = d'.
Proof.
move=> o o' kk i i'; have [e [r [e2 r2 E K]]] := falling_letter o i.
have [e' [r' [e2' r2' E' K']]] := falling_letter o' i'.
have [h he] : hub d = hub d' /\ e = e'.
  by rewrite kk K' in K; move: e2 r2 e2' r2' K; clear; split; numbers.
by apply: (place_inj C) => //; move: E E' h he; clear; numbers.
Qed.

(* ---- One step ---- *)
Lemma step_down d k : in_dart (iter k sigma d) -> hub d = (hub (motion k d)).+1 /\
  (0 < hub (motion k d) -> out_dart (motion k d)).
Proof. by move/(way_in C); rewrite hub_turn. Qed.

Lemma step_near d k : 0 < hub d <= N -> ~~ in_dart (iter k sigma d) ->
  hub (motion k d) = hub d \/ hub (motion k d) = (hub d).+1.
Proof.
move=> h i; case o: (out_dart (iter k sigma d)).
  by right; rewrite /motion (way_out C o) hub_turn.
by left; rewrite /motion (near_loops C) ?hub_turn ?o.
Qed.

Lemma step_far d k : N < hub d -> N < hub (motion k d) \/
  [/\ hub d = N.+1, hub (motion k d) = N & in_dart (iter k sigma d)].
Proof.
move=> h; case i: (in_dart (iter k sigma d)).
  have [E _] := step_down i; case: (ltnP N (hub (motion k d))) => [l|l]; [by left | right].
  by rewrite E in h *; have -> : hub (motion k d) = N by apply/eqP; rewrite eqn_leq l.
left; case o: (out_dart (iter k sigma d)).
  by rewrite /motion (way_out C o) hub_turn ltnW.
by rewrite /motion (far_edges C) ?hub_turn ?i ?o.
Qed.

(* ---- The shape of a home word ---- *)
Fixpoint falls w d :=
  if w is k :: w' then [&& out_dart d, in_dart (iter k sigma d) & falls w' (motion k d)] else hub d == 0.

Lemma home_word_hubs w d : home_word w d -> hub (walk w d) = 0 /\ uniq (map hub (passed w d)).
Proof.
case/andP; rewrite (hub_vertex C) (hub_start C) eq_sym => /eqP -> P; split=> //.
rewrite uniq_pairwise pairwise_map; apply: sub_pairwise P => x y /=.
by rewrite (hub_vertex C).
Qed.

Lemma near_falls w d : hub d <= N -> (0 < hub d -> out_dart d) -> (hub d).+1 \notin map hub (passed w d) ->
  uniq (map hub (passed w d)) -> hub (walk w d) = 0 -> falls w d /\ size w = hub d.
Proof.
elim: w d => [|k w IH] d hN o n U /= E; first by rewrite E.
have h0 : 0 < hub d.
  rewrite lt0n; apply: contra n => /eqP h; rewrite h /= h inE orbC.
  have -> : 1 = hub (motion k d) by rewrite (leave_v0 C) ?hub_turn.
  by case: (w) => [|k' w'] /=; rewrite inE eqxx.
have first : hub (motion k d) \in map hub (passed w (motion k d)).
  by case: (w) => [|k' w'] /=; rewrite inE eqxx.
case/andP: U => nd U; rewrite o //=; case i: (in_dart (iter k sigma d)); last first.
  have [e|e] := @step_near d k (introT andP (conj h0 hN)) (negbT i); rewrite e in first.
    by rewrite first in nd.
  by rewrite /= inE first orbT in n.
have [h o1] := step_down i; have [| |E1 s] := IH (motion k d) _ o1 _ U E.
- by rewrite -ltnS -h ltnW.
- by rewrite -h.
by rewrite E1 s h.
Qed.

Theorem home_word_falls w d : N < hub d -> home_word w d -> exists u v,
  [/\ w = u ++ v, size u <= F, hub (walk u d) = N, falls v (walk u d) & size v = N].
Proof.
move=> h /home_word_hubs[E U].
suff [u [v [e su hu fv sv]]] : exists u v, [/\ w = u ++ v,
    size u <= size [seq j <- map hub (passed w d) | N < j], hub (walk u d) = N,
    falls v (walk u d) & size v = N].
  exists u, v; split=> //; apply: leq_trans su _; rewrite -[X in _ <= X](size_iota N.+1 F).
  apply: uniq_leq_size; first by rewrite filter_uniq.
  move=> j; rewrite mem_filter mem_iota => /andP[-> /mapP[x _ ->]].
  by rewrite addSn ltnS (hub_last C).
elim: w d h E U => [|k w IH] d h /= E; first by rewrite E in h.
case/andP=> nd U; rewrite h /=; have [h1|[hd h1 i]] := step_far k h.
  have [u [v [-> su hu fv sv]]] := IH _ h1 E U.
  by exists (k :: u), v; split.
exists [:: k], w; have [hh o] := step_down i.
have n : (hub (motion k d)).+1 \notin map hub (passed w (motion k d)) by rewrite h1 -hd.
by have [fw sw] := near_falls (eq_leq h1) o n U E; rewrite sw h1; split.
Qed.

(* from a near hub there is no other way than down *)
Lemma passes_by l w x : l <= N -> l <= hub x -> hub (walk w x) = 0 -> l \in map hub (passed w x).
Proof.
move=> lN; elim: w x => [|k w IH] x; first by move=> + /= E; rewrite E leqn0 inE => /eqP->.
rewrite passed_cons /= inE leq_eqVlt => /predU1P[->|lx] E; first by rewrite eqxx.
apply/orP; right; apply: IH => //; case: (ltnP N (hub x)) => hN.
  by have [h|[_ -> _]] := step_far k hN; [exact: leq_trans lN (ltnW h) | ].
case i: (in_dart (iter k sigma x)); first by have [h _] := step_down i; rewrite h in lx.
have hx : 0 < hub x <= N by rewrite hN (leq_ltn_trans _ lx).
by case: (step_near hx (negbT i)) => ->; [exact: ltnW | exact: leqW (ltnW lx)].
Qed.

Theorem near_home_word w d : 0 < hub d <= N -> home_word w d ->
  exists k v, [/\ w = k :: v, falls v (motion k d), hub d = (hub (motion k d)).+1 & size v = hub (motion k d)].
Proof.
move=> /[dup] hd /andP[h0 hN] /home_word_hubs; case: w => [|k w] [E U]; first by rewrite E in h0.
move: U; rewrite passed_cons map_cons cons_uniq => /andP[n U]; case i: (in_dart (iter k sigma d)).
  have [h o] := step_down i; exists k, w; rewrite h in n.
  by have [|f sz] := near_falls _ o n U E; [rewrite -ltnS -h ltnW | ].
case/negP: n; apply: (@passes_by _ w (motion k d) hN _ E); have := step_near hd (negbT i).
by case=> ->; rewrite ?leqnSn.
Qed.

(* ---- Wrong walkers ---- *)
Definition height d := if N < hub d then N.+1 else hub d.
Definition flag d := (hub d == 0) || out_dart d.
Definition above d := if N < hub d then 2 * N.+1 else 2 * hub d + flag d.

Lemma above_step z z' k : out_dart z -> in_dart (iter k sigma z) -> z' <> z -> 0 < hub z' ->
  above z' <= (above (motion k z')).+1.
Proof.
move=> o i ne h; rewrite {1}/above; case: (ltnP N (hub z')) => hN.
  have [h1|[_ h1 i']] := step_far k hN; rewrite /above; first by rewrite h1.
  have [_ o1] := step_down i'; have -> : flag (motion k z').
    by rewrite /flag; case: posnP => // /o1 ->; rewrite orbT.
  by rewrite h1 ltnn mulnS addn1 add2n.
case i': (in_dart (iter k sigma z')).
  have no : ~~ out_dart z' by apply/negP=> o'; apply: ne; exact: falling_apart o' o _ i' i.
  have [e o1] := step_down i'; rewrite /above.
  have -> : N < hub (motion k z') = false.
    by apply/negbTE; rewrite -leqNgt; apply: leq_trans hN; rewrite e.
  rewrite {1}/flag (negbTE no) orbF (gtn_eqF h) addn0 e mulnS.
  have -> : flag (motion k z') by rewrite /flag; case: posnP => // /o1 ->; rewrite orbT.
  by rewrite addn1 add2n.
have := @step_near z' k (introT andP (conj h hN)) (negbT i') => st.
have le : 2 * hub z' <= above (motion k z').
  rewrite /above; case: ifP => _; first by rewrite leq_mul2l leqW.
  by apply: leq_trans (leq_addr _ _); rewrite leq_mul2l; case: st => ->; rewrite ?leqnn ?leqnSn orbT.
apply: leq_trans (_ : (2 * hub z').+1 <= _); last by [].
by rewrite -[X in _ <= X]addn1 leq_add2l; case: flag.
Qed.

Lemma above_home z : 2 <= above z -> 0 < hub z.
Proof. by rewrite /above /flag; case: posnP => // ->. Qed.

Lemma falling_alone w z z' t : falls w z -> z' <> z -> size w + 2 <= above z' ->
  0 < hub (walk (take t w) z').
Proof.
elim: w z z' t => [|k w IH] z z' t /=; first by move=> _ _; exact: above_home.
case/and3P=> o i f ne p; have h : 0 < hub z' by apply: above_home; apply: leq_trans p; rewrite addn2.
case: t => [|t] //=; apply: (IH (motion k z)) => //; first by move/motion_inj.
by rewrite -ltnS; apply: leq_trans p (above_step o i ne h).
Qed.

Lemma height_step k z : 0 < hub z -> height z <= (height (motion k z)).+1.
Proof.
rewrite /height => h; case: (ltnP N (hub z)) => hN.
  by have [->|[_ -> _]] := step_far k hN; rewrite ?ltnn.
case i: (in_dart (iter k sigma z)).
  have [e _] := step_down i; have -> : N < hub (motion k z) = false.
    by apply/negbTE; rewrite -leqNgt; apply: leq_trans hN; rewrite e.
  by rewrite e.
have := @step_near z k (introT andP (conj h hN)) (negbT i); case: ifP => _; first by rewrite leqW // leqW.
by case=> ->; rewrite ?leqW.
Qed.

Lemma height_far w d : N < hub d -> size w <= N -> N.+1 <= height (walk w d) + size w.
Proof.
move=> h; elim/last_ind: w => [|w k IH]; first by rewrite /height /= h addn0.
rewrite size_rcons walk_rcons => lw; apply: leq_trans (IH (ltnW lw)) _.
rewrite addnS -addSn leq_add2r; apply: height_step.
have := IH (ltnW lw); rewrite /height; case: (ltnP N (hub _)) => hN.
  by move=> _; exact: leq_ltn_trans (leq0n _) hN.
by move=> le; rewrite lt0n; apply/eqP=> e; rewrite e add0n in le; rewrite ltnNge ltnW in lw.
Qed.

Lemma short_away w d t : N < hub d -> size w <= N -> 0 < hub (walk (take t w) d).
Proof.
move=> h sw; have s : size (take t w) <= N.
  by apply: leq_trans sw; rewrite size_take; case: ltnP => // /ltnW.
have := height_far h s; rewrite /height; case: (ltnP N (hub _)) => hN.
  by move=> _; exact: leq_ltn_trans (leq0n _) hN.
by case: posnP => // ->; rewrite add0n ltnNge s.
Qed.

Lemma early_away w d t : N < hub d -> size w <= F -> 0 < hub (walk (take t w) d).
Proof. by move=> h sw; apply: short_away h _; apply: leq_trans sw _; rewrite leq_pmull. Qed.

(* home words of near darts are too short, and a dart at v0 has none but the empty one *)
Lemma near_word_short w d : hub d <= N -> home_word w d -> size w = hub d.
Proof.
move=> hN H; case: (posnP (hub d)) => [h0|h0]; last first.
  by have [k [v [-> _ -> sz]]] := near_home_word (introT andP (conj h0 hN)) H; rewrite -sz.
have [E U] := home_word_hubs H; case: w {H} E U => [|k w] //= E /andP[/negP[]]; rewrite h0 -E.
by elim: w (motion k d) {E} => [|k' w IH] x /=; rewrite inE ?eqxx // IH orbT.
Qed.

Theorem wrong_walkers w y y' t : home_word w y -> N < hub y' -> y' <> y ->
  ~~ at_same_vertex start (walk (take t w) y').
Proof.
move=> H hy' ne; rewrite (hub_vertex C) (hub_start C) eq_sym -lt0n; case: (leqP (hub y) N) => hy.
  by apply: short_away hy' _; rewrite (near_word_short hy H).
have [u [v [-> su hu fv sv]]] := home_word_falls hy H.
rewrite take_cat; case: ifP => [_|_]; first exact: early_away.
have walk_cat (a b : seq nat) x : walk (a ++ b) x = walk b (walk a x) by elim: a x => //= k a IH x.
rewrite walk_cat; apply: falling_alone fv _ _; first by move/walk_inj.
have le : size u <= N by apply: leq_trans su _; rewrite leq_pmull.
have := height_far hy' le; rewrite sv /height /above; move: su.
case: (ltnP N (hub _)) => _; first by clear; numbers.
by move=> su hN; apply: leq_trans (leq_addr _ _); move: su hN; move: (hub _); clear; numbers.
Qed.

(* ---- Home words part ---- *)
Lemma falling_class v z j : falls v z -> j < size v ->
  (nth 0 v j %% R) %/ 4 + j = hub z.
Proof.
elim: v z j => [|k v IH] z j //= /and3P[o i f]; case: j => [_|j] /=.
  have [e [r [e2 r2 _ ->]]] := falling_letter o i; rewrite addn0 -addnA mulnC divnMDl //.
  by rewrite divn_small ?addn0 //; move: e2 r2; clear; numbers.
rewrite ltnS => lj; have [-> _] := step_down i; by rewrite addnS (IH _ _ f lj).
Qed.

Lemma same_letters u u' d : N < hub d -> size u <= F ->
  map (modn^~ R) u = map (modn^~ R) u' -> walk u d = walk u' d.
Proof.
move=> h su E; have: forall t, 0 < hub (walk (take t u) d) by move=> t; exact: early_away.
elim: u u' d {h su} E => [|k u IH] [|k' u'] d //= [e E] H.
have h0 := H 0; have -> : motion k d = motion k' d by rewrite /motion -ring_turn // e ring_turn.
by apply: IH => // t; have := H t.+1; rewrite /= /motion -(ring_turn k) // e ring_turn.
Qed.

Lemma far_words_part w w' y y' : N < hub y -> N < hub y' -> home_word w y -> home_word w' y' -> y' <> y ->
  map (modn^~ R) (take F.+1 w) <> map (modn^~ R) (take F.+1 w').
Proof.
move=> hy hy' /(home_word_falls hy)[u [v [-> su hu fv sv]]].
case/(home_word_falls hy')=> [u' [v' [-> su' hu' fv' sv']]] ne E.
have F0 : 0 < F by case: (posnP F) hy => // F0; have := hub_last C y; rewrite F0 leqn0 => /eqP->.
have nth_eq j : j <= F -> nth 0 (u ++ v) j = nth 0 (u' ++ v') j %[mod R].
  have long (x x' : seq nat) : size x' = N -> F < size (x ++ x').
    by move=> e; rewrite size_cat e; move: F0; clear; numbers.
  move=> jF; have := congr1 (nth 0 ^~ j) E; rewrite !(nth_map 0) ?size_takel ?long //.
  by rewrite !nth_take.
have class (x x' : seq nat) z j : falls x' z -> size x <= j <= F -> size x' = N -> hub z = N ->
    (nth 0 (x ++ x') j %% R) %/ 4 + j = N + size x.
  move=> f /andP[lj jF] sx hz; rewrite nth_cat ltnNge lj /= -{2}(subnK lj) addnA (falling_class f) ?hz //.
  by rewrite sx ltn_subLR //; move: F0 jF; clear; numbers.
have j_le : maxn (size u) (size u') <= F by rewrite geq_max su su'.
have := class u v _ (maxn (size u) (size u')) fv; rewrite leq_maxl j_le => /(_ isT sv hu).
have := class u' v' _ (maxn (size u) (size u')) fv'; rewrite leq_maxr j_le => /(_ isT sv' hu').
rewrite (nth_eq _ j_le) => -> /addnI s.
have same : map (modn^~ R) u = map (modn^~ R) u'.
  apply: (@eq_from_nth _ 0); rewrite !size_map // => i li.
  rewrite !(nth_map 0) ?s //; have := nth_eq i (leq_trans (ltnW li) su).
  by rewrite !nth_cat s li.
rewrite (same_letters hy' su' (esym same)) in fv' hu'.
have := nth_eq _ su; rewrite !nth_cat s !ltnn subnn.
case: (v) fv sv => [|k v1] fv sv.
  by move: sv => /= sv; exfalso; move: F0 sv; clear; numbers.
case: (v') fv' sv' => [|k' v1'] fv' sv'.
  by move: sv' => /= sv'; exfalso; move: F0 sv'; clear; numbers.
move: fv fv' => /= /and3P[o i _] /and3P[o' i' _] kk.
by apply: ne; apply: (@walk_inj _ u); exact: falling_apart o' o (esym kk) i' i.
Qed.

(* where the one begins to fall it is at the last near hub, and the other has left that *)
Lemma near_word_parts w w' y y' : N < hub y -> hub y' <= N -> home_word w y -> home_word w' y' ->
  map (modn^~ R) (take F.+1 w) <> map (modn^~ R) (take F.+1 w').
Proof.
move=> hy hy' /(home_word_falls hy)[u [v [-> su hu fv sv]]] H' E.
have F0 : 0 < F by case: (posnP F) hy => // F0; have := hub_last C y; rewrite F0 leqn0 => /eqP->.
have u0 : 0 < size u by case: u hu {su E fv} => //= hu; rewrite hu ltnn in hy.
have sw : F < size (u ++ v) by rewrite size_cat sv; move: F0; clear; numbers.
have sw' : F < size w'.
  have := congr1 size E; rewrite !size_map size_takel // size_take.
  by case: ltnP => [/ltnW|_ <-].
have h0 : 0 < hub y' by rewrite -(near_word_short hy' H') (leq_ltn_trans _ sw').
have [k [v' [e f h sz]]] := near_home_word (introT andP (conj h0 hy')) H'.
have lv : 0 < size v by rewrite sv muln_gt0.
have := congr1 (nth 0 ^~ (size u)) E; rewrite !(nth_map 0) ?size_takel // !nth_take // e.
rewrite nth_cat ltnn subnn -(prednK u0) [nth _ (_ :: _) _]/= => c.
have lt : (size u).-1 < size v' by rewrite e /= ltnS in sw'; apply: leq_trans sw'; rewrite prednK.
have := falling_class f lt; rewrite -c; have := falling_class fv lv; rewrite addn0 hu => ->.
by rewrite h in hy'; move: hy'; clear; numbers.
Qed.

Theorem home_words_part w w' y y' : N < hub y -> home_word w y -> home_word w' y' -> y' <> y ->
  map (modn^~ R) (take F.+1 w) <> map (modn^~ R) (take F.+1 w').
Proof.
move=> hy H H' ne; case: (leqP (hub y') N) => hy'; first exact: near_word_parts H H'.
exact: far_words_part H H' ne.
Qed.
End Corridor.
