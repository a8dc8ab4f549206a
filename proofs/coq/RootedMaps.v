(* ---------------------------------------------------------------------------------------------
   Rooted maps: sameness is an equivalence, and is kept by going back.                       Section V

     isomorphic_refl, isomorphic_sym, isomorphic_trans   sameness is an equivalence;
     isomorphic_connected, isomorphic_wellformed   and carries over connectedness, wellformedness.
     same_map_join        being the same map, wherever rooted, is transitive.
     walk_in_inj          a fixed list of motions leads different darts to different darts.
     isomorphic_back      maps that are the same seen from where a walk ends are the same seen from
                          where it began.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma isomorphic_refl M : isomorphic M M.
Proof. by exists id, id; split. Qed.

Lemma isomorphic_sym M N : wellformed M -> isomorphic M N -> isomorphic N M.
Proof.
move=> W [f [g [F G r]]]; exists g, f; split.
- move=> y dy; have [dx e] := G y dy; have [_ _ s a] := F _ dx; split=> //.
  + by rewrite -{1}e -s; have [_ -> _ _] := F _ (wellformed_sigma W dx).
  + by rewrite -{1}e -a; have [_ -> _ _] := F _ (wellformed_alpha W dx).
- by move=> x dx; have [d e _ _] := F _ dx.
- by rewrite -r; have [_ -> _ _] := F _ (wellformed_root W).
Qed.

Lemma isomorphic_trans M N K : isomorphic M N -> isomorphic N K -> isomorphic M K.
Proof.
move=> [f [g [F G r]]] [f' [g' [F' G' r']]]; exists (f' \o f), (g \o g'); split=> /=.
- move=> x dx; have [d e s a] := F _ dx; have [d' e' s' a'] := F' _ d.
  by split; rewrite ?e' ?s ?a.
- by move=> y dy; have [d e] := G' _ dy; have [d' e'] := G _ d; rewrite e'.
- by rewrite r.
Qed.

Lemma isomorphic_connected M N : wellformed M -> isomorphic M N -> connected N -> connected M.
Proof.
move=> W /(isomorphic_sym W) [g [f [G F r]]] CN A A0 As Aa x dx; have [dy <-] := F x dx.
apply: (CN (fun y => A (g y))) dy => [|y dy Ay|y dy Ay]; first by rewrite r.
  by have [d _ -> _] := G _ dy; exact: As.
by have [d _ _ ->] := G _ dy; exact: Aa.
Qed.

Lemma isomorphic_wellformed M N : isomorphic M N -> wellformed N -> is_dart M (root M) ->
  (forall x, is_dart M x -> is_dart M (sigma_of M x)) ->
  (forall x, is_dart M x -> is_dart M (alpha_of M x)) -> wellformed M.
Proof.
move=> [f [g [F G r]]] WN dr ds da.
have fi x y : is_dart M x -> is_dart M y -> f x = f y -> x = y.
  by move=> dx dy E; have [_ <- _ _] := F x dx; have [_ <- _ _] := F y dy; rewrite E.
split=> // x.
- move=> y dx dy E; have [fx _ sx _] := F x dx; have [fy _ sy _] := F y dy.
  by apply: (fi x y) => //; apply: (wellformed_inj WN) => //; rewrite -sx -sy E.
- move=> dx; have [fx _ _ ax] := F x dx; have [_ _ _ aax] := F _ (da x dx).
  by apply: fi; rewrite ?aax ?ax ?(wellformed_alphaK WN) //; auto.
- move=> dx E; have [fx _ _ ax] := F x dx; apply: (wellformed_alpha_neq WN fx).
  by rewrite -ax E.
Qed.

(* ---- The same map, wherever it is rooted ---- *)
Lemma isomorphic_same_map M N : wellformed M -> isomorphic M N -> same_map M N.
Proof.
move=> W I; have [f [g [F _ r]]] := I; exists (root N); last by case: (N) I.
by rewrite -r; have [] := F _ (wellformed_root W).
Qed.

(* two maps that are the same as one third are the same *)
Lemma same_map_join K M N : wellformed K -> wellformed M -> same_map K M -> same_map K N -> same_map M N.
Proof.
move=> WK WM [d dM I] [e eN J].
have [f [g [F G _]]] := isomorphic_trans (isomorphic_sym WK I) J; rewrite /= in F G.
exists (f (root M)); first by have [] := F _ (wellformed_root WM).
by exists f, g.
Qed.

Lemma same_map_sym M N : wellformed M -> wellformed N -> same_map M N -> same_map N M.
Proof. by move=> WM WN /(same_map_join WM WN); apply; exact: isomorphic_same_map (isomorphic_refl M). Qed.

Section Moves.
Variable M : rooted_map.
Hypothesis W : wellformed M.

Lemma is_dart_turn k x : is_dart M x -> is_dart M (iter k (sigma_of M) x).
Proof. by move=> dx; elim: k => //= k; exact: wellformed_sigma. Qed.

Lemma is_dart_motion k x : is_dart M x -> is_dart M (motion_in M k x).
Proof. by move/(is_dart_turn k)/(wellformed_alpha W). Qed.

Lemma turn_in_inj k x y : is_dart M x -> is_dart M y ->
  iter k (sigma_of M) x = iter k (sigma_of M) y -> x = y.
Proof.
by move=> dx dy; elim: k => //= k IH /(wellformed_inj W (is_dart_turn k dx) (is_dart_turn k dy)).
Qed.
Lemma motion_in_inj k x y : is_dart M x -> is_dart M y -> motion_in M k x = motion_in M k y -> x = y.
Proof.
move=> dx dy /(congr1 (alpha_of M)); rewrite /motion_in !(wellformed_alphaK W) ?is_dart_turn //;
  exact: turn_in_inj.
Qed.

Lemma walk_in_inj w x y : is_dart M x -> is_dart M y -> walk_in M w x = walk_in M w y -> x = y.
Proof.
by elim: w x y => //= k w IH x y dx dy /IH E; apply: (@motion_in_inj k) => //; apply: E;
  exact: is_dart_motion.
Qed.

End Moves.
(* if two maps are the same seen from where one list of motions ends, they are the same
   seen from its start *)
Lemma isomorphic_back M N w x y : wellformed M -> wellformed N -> is_dart M x -> is_dart N y ->
  isomorphic (rooted_at M (walk_in M w x)) (rooted_at N (walk_in N w y)) ->
    isomorphic (rooted_at M x) (rooted_at N y).
Proof.
move=> WM WN dx dy [f [g [F G /= r]]]; exists f, g; split=> //=.
have fi k z : is_dart M z -> f (iter k (sigma_of M) z) = iter k (sigma_of N) (f z).
  move=> dz; elim: k => //= k IH; have [_ _ -> _] := F _ (is_dart_turn WM k dz); by rewrite /= IH.
have fr v z : is_dart M z -> f (walk_in M v z) = walk_in N v (f z).
  elim: v z => //= k v IH z dz; rewrite IH ?is_dart_motion // /motion_in.
  by have [_ _ _ /= ->] := F _ (is_dart_turn WM k dz); rewrite fi.
by apply: (walk_in_inj WN (w := w)) => //; [have [] := F _ dx | rewrite -fr].
Qed.

Lemma rooted_wellformed (G : combinatorial_map) (d : G) : wellformed (rooted d).
Proof.
split=> //= [x y _ _ /sigma_inj //|x _|x _ E]; first exact: alphaK.
by have := alpha_neq x; rewrite E eqxx.
Qed.

Lemma rooted_connected (G : combinatorial_map) (d : G) : connected (rooted d).
Proof. by move=> A /= A0 As Aa x _; apply: (everywhere A0); auto. Qed.

Lemma same_map_edges (G H : combinatorial_map) (d : G) (e : H) :
  same_map (rooted d) (rooted e) -> edges G = edges H.
Proof.
move=> [x _ [f [g [F G' _]]]]; apply: double_inj; rewrite !edges_double; apply: (@bij_eq_card _ _ f).
by exists g => y; [have [] := F y isT | have [] := G' y isT].
Qed.

