% READINPUT  Reads the user's loadInput.m.
%
% CALL: RAW = readInput ()
%       RAW = readInput (ROOT, FOLDER)
%
% ROOT    folder of the toolbox (text, default: the one of this file)
% FOLDER  case folder (text, default pwd)
% RAW     struct: Input, optim, modelVars, assign, paramLims (the five outputs,
%         as published), root, folder
%
% Where Input has no store, it is the one that the environment names in
% DECALIOC_STORE. loadInput is the file of the case folder or else of the
% toolbox.
%
% Tests that were advised and have been measured since (filledMeasurements) are further
% models, at the end of Input.model; raw.further has their names. Each has the
% CPUs of the model whose name its own begins with, or 1.
%
% Errors: DEcalioc:readInput:missingFile, :brokenInput, :decimalComma

function raw = readInput (root, folder)
  if nargin < 2
    root = fileparts (fileparts (fileparts (mfilename ('fullpath'))));
    folder = pwd ();
  end
  raw = struct ('root', root, 'folder', folder);
  % which would parse it, outside of try
  file = file_in_loadpath ('loadInput.m');
  if isempty (file)
    error ('DEcalioc:readInput:missingFile', ...
           ['readInput: a file loadInput.m is expected in %s or %s. Copy ' ...
            'the one of the toolbox and edit it.'], folder, root);
  end
  checkDecimals (file);
  % Octave keeps that of another case after a change of folder
  clear ('-functions', 'loadInput');
  try
    [raw.Input, raw.optim, raw.modelVars, raw.assign, raw.paramLims] = ...
      feval ('loadInput');
  catch err
    error ('DEcalioc:readInput:brokenInput', ...
           ['readInput: %s must return [Input, optim, modelVars, assign, ' ...
            'paramLims], but running it gave: %s'], ...
           file, whereAndWhat (err));
  end
  place = getenv ('DECALIOC_STORE');
  if ~isempty (place) && isstruct (raw.Input) && ...
     isempty (givenField (raw.Input, 'store', ''))
    raw.Input.store = place;
  end
  raw = withFurther (raw);
end

% x = 0,03; is x = 0, and then 3.
function checkDecimals (file)
  line = regexp (readText (file), '^[^%#\n''"=([{]*=[ \t]*[-+]?\d+,\d+[ \t]*;', 'match', ...
                 'once', 'lineanchors');
  if ~isempty (line)
    error ('DEcalioc:readInput:decimalComma', ...
           ['readInput: decimals must stand behind a point, got ''%s'' in %s, which ' ...
            'Octave takes for two commands.'], strtrim (line), file);
  end
end

function raw = withFurther (raw)
  raw.further = filledMeasurements (raw.folder);
  isUsable = isstruct (raw.Input) && isfield (raw.Input, 'model') && ...
             isfield (raw.Input, 'cpu') && ~isempty (raw.further);
  if ~isUsable || ~(iscellstr (raw.Input.model) || ischar (raw.Input.model))
    return
  end
  own = cellstr (raw.Input.model);
  raw.further = setdiff (raw.further, own);
  for name = raw.further
    from = find (cellfun (@(m) strncmp (name{1}, [m, '_'], numel (m) + 1), ...
                          own), 1);
    raw.Input.cpu(numel (own) + 1) = max ([raw.Input.cpu(from), 1]);
    own{end + 1} = name{1};
  end
  raw.Input.model = own;
end

function text = whereAndWhat (err)
  text = strtrim (err.message);
  % of a file that does not parse the message says where
  if ~isempty (err.stack) && ~strncmp (text, 'parse error', 11)
    text = sprintf ('%s (%s, line %d)', text, err.stack(1).name, ...
                    err.stack(1).line);
  end
end

%!test
%! % it fails, or does not even parse
%! for bad = {'a = nope;', 'nope', 'brokenInput'; ...
%!            'a = [1, ;', 'parse error near line 1', 'brokenInput'; ...
%!            sprintf("\n  m.r = 0,03;   %% m\n"), 'm.r = 0,03', 'decimalComma'}'
%!   folder = emptyFolder ();
%!   file = fullfile (folder, 'loadInput.m');
%!   writeAtomic (file, ['function [a, b, c, d, e] = loadInput (), ', ...
%!                       bad{1}, ' end']);
%!   addpath (folder);
%!   unwind_protect
%!     try
%!       loadCase (folder, folder);
%!     catch err
%!     end
%!     assert (err.identifier, ['DEcalioc:readInput:', bad{3}]);
%!     assert (! isempty (strfind (err.message, bad{2})));
%!     assert (! isempty (strfind (err.message, file)));
%!   unwind_protect_cleanup
%!     rmpath (folder);
%!   end_unwind_protect
%! end
%! clear loadInput
%!test
%! raw = readInput ();
%! assert (raw.root, fileparts (fileparts (which ('startToolbox'))));
%! assert (numel (raw.assign), columns (raw.paramLims));
%!test
%! % of two cases in one Octave each has its own
%! folders = {emptyFolder(), emptyFolder()};
%! here = pwd ();
%! back = onCleanup (@() cd (here));
%! for k = 1:2
%!   writeAtomic (fullfile (folders{k}, 'loadInput.m'), ...
%!                sprintf (["function [a, b, c, d, e] = loadInput ()\n", ...
%!                          "[a, b, c, d, e] = deal (%d);\nend\n"], k));
%!   cd (folders{k});
%!   assert (readInput ('', folders{k}).optim, k);
%! end
%! cd (here);
%! clear loadInput

% SPDX-License-Identifier: GPL-3.0-only
