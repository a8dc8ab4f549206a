; A model of the hypotheses of folding-links-forced.smt2
; Says: The world is one vertex with one loop a0a1, the marker points to a0. The log: from r0 the
;   robot walks motion 0 and arrives at s0, at v0 again. r0 and s0 are linked, s1 is merged with
;   r0: next, s1 is linked to s0.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1))))
(declare-datatypes ((LogDart 0)) (((r0) (r1) (s0) (s1))))
(define-fun alpha ((x Dart)) Dart (ite (= x a0) a1 a0))
(define-fun place ((x LogDart)) Dart (ite (= x r1) a1 (ite (= x s0) a1 a0)))
(define-fun merged ((x0 LogDart) (x1 LogDart)) Bool (and (= x0 r0) (= x1 s1)))
(define-fun linked0 ((x0 LogDart) (x1 LogDart)) Bool (and (= x0 r0) (= x1 s0)))
(define-fun linked1 ((x0 LogDart) (x1 LogDart)) Bool
  (or (and (= x0 r0) (= x1 s0)) (and (= x0 s0) (= x1 r0)) (and (= x0 s1) (= x1 s0))))
(define-fun f () LogDart s1)
(define-fun g () LogDart s0)

(assert (forall ((d Dart)) (= (alpha (alpha d)) d)))
(assert (forall ((x LogDart) (y LogDart)) (=> (merged x y) (= (place x) (place y)))))
(assert (forall ((x LogDart) (y LogDart))
  (= (linked1 x y)
     (or (linked0 x y) (linked0 y x) (exists ((z LogDart)) (and (merged z x) (linked0 z y)))))))
(assert (forall ((x LogDart) (y LogDart)) (=> (linked0 x y) (= (place y) (alpha (place x))))))
(assert (linked1 f g))
(check-sat)
