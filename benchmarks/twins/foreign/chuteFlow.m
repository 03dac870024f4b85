% CHUTEFLOW  Flow down a rough chute, which stops below a certain angle.
%
% CALL: Q = chuteFlow (TANGENT, DEPTH, LAW)
%
%   TANGENT  1 x m or n x m, of the slope of the chute
%   DEPTH    n x 1, of the layer, in grains
%   LAW      struct of scalars or n x 1: low (tangent at which a deep layer
%            stops), high (that of a thin one), fade (depth in grains), flow
%   Q        n x m, discharge: flow h^2.5 (tan - stop) / (high - tan), 0 below
%            stop = low + (high - low) exp (-h / fade)
%
% After Pouliquen 1999; the denominator, of the friction law mu (I) of Jop et
% al. 2006, is kept above a tenth of high - low.
%
% See also: foreignLab

function Q = chuteFlow (tangent, depth, law)
  span = law.high - law.low;
  stop = law.low + span .* exp (-depth ./ law.fade);
  Q = law.flow .* depth.^2.5 .* max (0, tangent - stop) ./ ...
      max (0.1 * span, law.high - tangent);
end

%!test % nothing flows below the stopping angle, thin layers stop first
%! law = struct ('low', 0.35, 'high', 0.7, 'fade', 4, 'flow', 1);
%! assert (chuteFlow ([0.2, 0.35], 10, law), [0, 0]);
%! Q = chuteFlow (0.5, [2; 10], law);
%! assert (Q(1), 0);
%! assert (Q(2) > 0);
%! assert (all (diff (chuteFlow (0.4:0.02:0.68, 10, law)) > 0));
