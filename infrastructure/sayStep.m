% SAYSTEP  One line of text about the last step of a calibration.
%
% CALL: text = sayStep (state)
%
% See also: bookStep

function text = sayStep (state)
  step = state.history(end);
  text = sprintf ('%s %d: %d runs, residuals%s %%, probability %.2f', ...
                  step.stage, step.iteration, step.runs, ...
                  sprintf (' %.2f', 100 * step.residual), step.probability);
end
