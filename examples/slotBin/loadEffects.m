% LOADEFFECTS  What might be missing in the model of the slot bin.
%
% CALL: EFFECTS = loadEffects ()
%
% opening: the model has no front and back wall, at which a strip of the slot is
% as good as closed. timeOffset: it is not known when the clock was started.
%
% See also: listEffects, diagnoseGap

function effects = loadEffects ()
  effects = {'opening', 'timeOffset'};
end
