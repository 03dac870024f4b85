% RESIDUALTEXT  Residuals in percent as text, as long as they are few.
%
% CALL: TEXT = residualText (RESIDUAL, FORM)
%
% RESIDUAL  T x 1; NaN: not measured yet
% FORM      of sprintf, for one number
% TEXT      all of them up to ten, else the largest and how many there are

function text = residualText (residual, form)
  residual = 100 * residual(isfinite (residual));
  if numel (residual) <= 10
    text = sprintf (form, residual);
  else
    text = sprintf ([' up to', form, ' in %d targets'], ...
                    max (abs (residual)), numel (residual));
  end
end

%!assert (residualText ([0.01; NaN; -0.2], ' %.1f'), ' 1.0 -20.0')
%!assert (residualText (-0.01 * (1:12)', ' %.0f'), ' up to 12 in 12 targets')
