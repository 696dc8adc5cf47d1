local function turned(profile, closed)
  return object { shape = mesh.lathe { profile = profile, closed = closed } }
end
local function straight(profile, closed)
  return object { shape = mesh.lathe { profile = profile, closed = closed, spline = false } }
end
return scene {
  objects = {
    turned({ { 0, 0 }, { 0, 0 } }),
    turned({ { 0.1, 0 }, { 0.2, 0 }, { 0.1, 0 } }, true),
    turned({ { 0, 0 }, { -0.1, 0.1 }, { 0, 0.2 } }),
    turned({ { 0, 0 }, { 0.1, 0.1 }, { 0, 0.15 }, { 0.1, 0.2 } }),
    turned({ { 0, 0 }, { 0.1, 0 }, { 0.1, 0.1 } }, true),
    turned({ { 0, 0 }, { 0.2, 0.1 }, { 0.1, 0.1 }, { 0.2, 0 }, { 0, 0.3 } }),
    turned({ { 0.3, 0 }, { 0.001, 0.1 }, { 0.001, 0.12 }, { 0.3, 0.3 } }),
    -- Two walls in line, and a crossing behind them.
    straight({ { 0.1, 0 }, { 0.1, 0.1 }, { 0.2, 0.1 }, { 0.2, 0.2 }, { 0.1, 0.2 }, { 0.1, 0.4 }, { 0.3, 0.5 }, { 0.1, 0.5 }, { 0.3, 0.4 } }),
    straight({ { 0.2, 0 }, { 0.2, 0.2 }, { 0.1, -0.1 } }),
    straight({ { 0.1, 0.1 }, { 0.3, 0.3 }, { 0.3, 0.1 }, { 0.1, 0.3 } }, true),
    straight({ { 0.1, 0 }, { 0.3, 0 }, { 0.2, 0 }, { 0.2, 0.3 } }),
    object { shape = mesh.text { text = "NAGOYA!" } },
    object { shape = mesh.text { text = "  " } },
  },
}
