% LOADSURROGATE  Reads a surrogate that saveSurrogate wrote.
%
% CALL: SURROGATE = loadSurrogate (FILE)
%
% FILE       char, path; SURROGATE  scalar struct of fitSurrogate
%
% Errors: DEcalioc:loadSurrogate:missingFile

function surrogate = loadSurrogate (file)
  if ~exist (file, 'file')
    error ('DEcalioc:loadSurrogate:missingFile', ...
           ['loadSurrogate: %s must be a file of createKrigingModels, ' ...
            'it is missing.'], file);
  end
  kept = load (file, 'kept').kept;
  kept.unit = toUnit (kept.X, kept.limits);
  if isfield (kept, 'level')
    kept.unit = [kept.unit, kept.level];
  end
  kept.y = (kept.z - kept.shift) / kept.scale;
  surrogate = conditionSurrogate (kept, kept);
end

%!error id=DEcalioc:loadSurrogate:missingFile loadSurrogate ('no such file');
