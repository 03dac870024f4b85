% WRITEPROGRESS  Notes how far a calibration is: results/progress.json.
%
% CALL: writeProgress (CASE, STATE)
%
%   CASE   see newCase
%   STATE  see newState
%
% Holds params, probability, history (see newState) and date. It is
% there while a calibration is under way: writeCalibrationJson removes it.
%
% See also: reportPage, writeCalibrationJson

function writeProgress (Case, state)
  out = struct ('params', cell2struct (num2cell (state.found.params(:)), ...
                                       Case.names, 1), ...
                'probability', state.found.probability, ...
                'history', {num2cell(state.history(:)')}, ...
                'date', strftime ('%Y-%m-%d %H:%M', localtime (time ())));
  folder = fullfile (Case.folder, 'results');
  [~, ~] = mkdir (folder);
  writeAtomic (fullfile (folder, 'progress.json'), [jsonencode(out), "\n"]);
end

%!test
%! Case = struct ('names', {{'a', 'b'}}, 'folder', tempname ());
%! mkdir (Case.folder);
%! state = newState ([], [], struct ('params', [1, 2], 'probability', 0.5));
%! writeProgress (Case, state);
%! p = jsondecode (fileread (fullfile (Case.folder, 'results', ...
%!                                     'progress.json')));
%! assert (p.params.b, 2);
%! assert (p.probability, 0.5);
%! assert (isempty (p.history));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
