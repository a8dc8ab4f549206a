; A model of the hypotheses of vertex-keeps-I2.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. S knows v0, v1 and a0b0; e = A1 leads to v2, which is new.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((MapDart 0)) (((A0) (A1) (B0) (B1) (C0) (C1))))
(declare-datatypes ((Vertex 0)) (((v0) (v1) (v2))))
(define-fun alpha ((x Dart)) Dart
  (ite (= x a0) b0 (ite (= x a1) c0 (ite (= x b0) a0 (ite (= x b1) c1 (ite (= x c0) a1 b1))))))
(define-fun vertex ((x Dart)) Vertex
  (ite (= x a0) v0 (ite (= x a1) v0 (ite (= x b0) v1 (ite (= x b1) v1 v2)))))
(define-fun seen0 ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1)))
(define-fun walked0 ((x Dart)) Bool (or (= x a0) (= x b0)))
(define-fun known0 ((x MapDart)) Bool (or (= x A0) (= x A1) (= x B0) (= x B1)))
(define-fun open0 ((x MapDart)) Bool (or (= x A1) (= x B1)))
(define-fun phi0 ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun name0 ((x Dart)) MapDart
  (ite (= x a0) A0 (ite (= x a1) A1 (ite (= x b0) B0 (ite (= x b1) B1 (ite (= x c0) C0 C1))))))
(define-fun seen1 ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1) (= x c0) (= x c1)))
(define-fun walked1 ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x c0)))
(define-fun known1 ((x MapDart)) Bool
  (or (= x A0) (= x A1) (= x B0) (= x B1) (= x C0) (= x C1)))
(define-fun open1 ((x MapDart)) Bool (or (= x B1) (= x C1)))
(define-fun phi1 ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun name1 ((x Dart)) MapDart
  (ite (= x a0) A0 (ite (= x a1) A1 (ite (= x b0) B0 (ite (= x b1) B1 (ite (= x c0) C0 C1))))))
(define-fun new ((x MapDart)) Bool (or (= x C0) (= x C1)))
(define-fun fresh ((x Dart)) MapDart
  (ite (= x a0) A0 (ite (= x a1) A1 (ite (= x b0) B0 (ite (= x b1) B1 (ite (= x c0) C0 C1))))))
(define-fun e () MapDart A1)
(define-fun entry () MapDart C0)

(assert (forall ((d Dart) (c Dart)) (=> (and (seen0 d) (= (vertex c) (vertex d))) (seen0 c))))
(assert (forall ((d Dart)) (=> (walked0 d) (and (seen0 d) (walked0 (alpha d))))))
(assert (forall ((x MapDart)) (=> (known0 x) (and (seen0 (phi0 x)) (= (name0 (phi0 x)) x)))))
(assert (forall ((d Dart)) (=> (seen0 d) (and (known0 (name0 d)) (= (phi0 (name0 d)) d)))))
(assert (forall ((x MapDart)) (=> (open0 x) (and (known0 x) (not (walked0 (phi0 x)))))))
(assert (forall ((d Dart)) (=> (and (seen0 d) (not (walked0 d))) (open0 (name0 d)))))
(assert (open0 e))
(assert (not (seen0 (alpha (phi0 e)))))
(assert (forall ((d Dart))
  (= (seen1 d) (or (seen0 d) (= (vertex d) (vertex (alpha (phi0 e))))))))
(assert (forall ((d Dart))
  (= (walked1 d) (or (walked0 d) (= d (phi0 e)) (= d (alpha (phi0 e)))))))
(assert (forall ((x MapDart))
  (= (new x) (exists ((d Dart)) (and (= (vertex d) (vertex (alpha (phi0 e)))) (= x (fresh d)))))))
(assert (forall ((d Dart)) (=> (= (vertex d) (vertex (alpha (phi0 e)))) (= (phi1 (fresh d)) d))))
(assert (= entry (fresh (alpha (phi0 e)))))
(assert (forall ((x MapDart)) (= (known1 x) (or (known0 x) (new x)))))
(assert (forall ((x MapDart)) (=> (known0 x) (= (phi1 x) (phi0 x)))))
(assert (forall ((d Dart)) (= (name1 d) (ite (seen0 d) (name0 d) (fresh d)))))
(assert (forall ((x MapDart))
  (= (open1 x) (or (and (open0 x) (not (= x e))) (and (new x) (not (= x entry)))))))
(check-sat)
